// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Surfaces as piecewise analytic functions with bounds in the complex plane: splines, planes, cylinders,
//! cones, spheres, tori and circles of any position turned about an axis. See analytic_curve.h.
#pragma once

#include "../spline/tensor_spline.h"
#include "analytic_curve.h"

#include <Eigen/Core>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Surface.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

class AnalyticSurface
{
public:
    //! \return nothing for any other kind of surface.
    static std::optional<AnalyticSurface> make(const Handle(Geom_Surface) & surface);

    //! Null for an analytic surface.
    [[nodiscard]] const TensorSpline *spline() const { return m_kind == Kind::Spline ? &m_spline : nullptr; }

    //! Where the surface is one analytic function: a rectangle between knots, or everything.
    struct Cell
    {
        int span_u = 0;
        int span_v = 0;

        friend bool operator==(const Cell &, const Cell &) = default;
    };
    [[nodiscard]] Cell cell_at(double u, double v) const;
    //! Low and high end of a cell in one direction (0: u, 1: v); infinite where the same function goes on: on
    //! an analytic surface, and past the last knot of a spline.
    struct Ends
    {
        double low = 0.0;
        double high = 0.0;
    };
    [[nodiscard]] Ends ends(const Cell &cell, int direction) const;

    //! Where the surface ends.
    [[nodiscard]] Ends domain(int direction) const;

    //! The function that the surface is on the cell; (u, v) may lie a little outside.
    [[nodiscard]] Eigen::Vector3d value(double u, double v, const Cell &cell) const;

    //! The same for many parameters on one cell. Refers to the surface.
    class OnCell
    {
    public:
        OnCell(const AnalyticSurface &surface, const Cell &cell);
        [[nodiscard]] Eigen::Vector3d value(double u, double v) const;
        //! At `lanes` parameters at once (vector_kernels.h); rows x, y, z.
        void lane_values(const double *u, const double *v, double *rows) const;

    private:
        const AnalyticSurface &m_surface;
        Cell m_cell;
        SpanBasis m_u;
        SpanBasis m_v;
    };

    //! Bound of |S_u| (0) or |S_v| (1), over the whole surface; on a cone as far as |v|.
    [[nodiscard]] double speed(int direction, double v) const;

    //! Degree of t -> S(u(t), v(t)) for polynomials u and v of the given degrees on one cell; nothing
    //! where that is no polynomial. A degree is empty where the coordinate is no polynomial.
    [[nodiscard]] std::optional<int> composed_degree(std::optional<int> u, std::optional<int> v) const;

    //! The surface around a piece of a pcurve, prepared for bounds in the complex plane.
    struct Patch
    {
        Eigen::Vector2d middle{0.0, 0.0};
        Eigen::Vector2d half{0.0, 0.0}; //!< half sides of the box of real parameters
        double longest = 0.0;           //!< bound of the Bernstein coefficients over the box, relative to its middle
        double weight_low = 1.0;
        double weight_high = 1.0;
    };
    [[nodiscard]] Patch patch(const Cell &cell, const Eigen::Vector3d &middle, const CurveReach &real) const;

    //! Bound of |S - point of the patch| where the parameters stray from the middle by complex numbers.
    [[nodiscard]] double growth(const Patch &patch, const CurveReach &reach) const;

    //! Bound of the rounding of value() at parameters as large as v.
    [[nodiscard]] double rounding(double v) const;

private:
    enum class Kind
    {
        Spline,
        Plane,
        Cone, //!< origin + (radius + v sine) e(u) + v cosine Z; a cylinder has sine 0
        //! origin + c(v) turned by u about Z, c = radius X + tube (cos v A + sin v B) in the frame's coordinates; on a torus
        //! A = X and B = Z, a sphere has radius 0
        Torus,
    };

    void prepare_spline();
    void take_elementary(const Handle(Geom_ElementarySurface) & surface);
    [[nodiscard]] bool take_turned_circle(const Handle(Geom_Surface) & surface);
    [[nodiscard]] double derivative_bound(int direction) const;
    [[nodiscard]] Eigen::Vector4d homogeneous(double u, double v, const Cell &cell) const;
    //! The same from the basis functions of the cell.
    [[nodiscard]] Eigen::Vector4d combined(const double *basis_u, const double *basis_v, const Cell &cell) const;
    [[nodiscard]] Eigen::Vector3d without_weight(const Eigen::Vector4d &point) const;
    //! Largest pole of a derivative of the numerator, relative to a centre, and of the weight on a cell.
    struct LocalSpeed
    {
        double numerator = 0.0;
        double weight = 0.0;
    };
    [[nodiscard]] LocalSpeed local_speed(const Cell &cell, int direction, const Eigen::Vector3d &centre) const;
    [[nodiscard]] double spline_growth(const Patch &patch, const CurveReach &reach) const;

    Kind m_kind = Kind::Spline;
    TensorSpline m_spline;
    double m_speed[2] = {0.0, 0.0};
    double m_size = 0.0; //!< largest coordinate
    Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_x = Eigen::Vector3d::UnitX();
    Eigen::Vector3d m_y = Eigen::Vector3d::UnitY();
    Eigen::Vector3d m_z = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d m_a = Eigen::Vector3d::UnitX();
    Eigen::Vector3d m_b = Eigen::Vector3d::UnitZ();
    double m_radius = 0.0;
    double m_tube = 0.0;
    double m_sine = 0.0;
    double m_cosine = 1.0;
};

} // namespace laminate_offset
