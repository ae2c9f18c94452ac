// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! What an edge's curve has to follow: a pcurve on a surface, its points and proofs about them.
#pragma once

#include "analytic_curve.h"
#include "analytic_surface.h"

#include "../spline/least_squares.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <optional>
#include <vector>

namespace laminate_offset
{

//! A pcurve on a surface over a parameter range.
struct CurveOnSurface
{
    Handle(Geom_Surface) surface;
    Handle(Geom2d_Curve) pcurve;
    double first = 0.0;
    double last = 0.0;

    [[nodiscard]] gp_Pnt value(double t) const;
};

//! How far a curve keeps from the surface at its pcurve's points [mm].
struct Deviation
{
    double bound = 0.0;
    bool proven = false; //!< else the bound is the largest distance seen
};

//! One pcurve on a surface, prepared for evaluation and proofs. Refers to its surface's form.
class EdgeTarget
{
public:
    //! \param form of the surface, null where it has none.
    EdgeTarget(const CurveOnSurface &on_surface, const AnalyticSurface *form);

    [[nodiscard]] const CurveOnSurface &on_surface() const { return m_on_surface; }
    [[nodiscard]] const AnalyticSurface *form() const { return m_form; }
    //! The surface as a spline, null where it is none.
    [[nodiscard]] const TensorSpline *spline() const;
    [[nodiscard]] Eigen::Vector2d uv(double t) const;
    [[nodiscard]] Eigen::Vector3d value(double t) const;
    //! The points at increasing parameters, relative to an origin, one a row: several are evaluated at once.
    [[nodiscard]] RowMatrix values(const std::vector<double> &parameters, const Eigen::Vector3d &origin) const;

    //! Deviation of a curve with the pcurve's parameters, proven wherever that is possible.
    //! \param target how small the bound has to be [mm].
    [[nodiscard]] Deviation deviation(const Handle(Geom_Curve) & curve, double target) const;
    //! The same of a single point.
    [[nodiscard]] Deviation deviation(const gp_Pnt &point, double target) const;

private:
    //! values() of one analytic piece of the pcurve.
    void add_values(const CurvePiece &piece, const double *parameters, RowMatrix &rows, Eigen::Index first,
                    Eigen::Index last) const;
    [[nodiscard]] std::optional<double> proven(const std::optional<AnalyticCurve> &curve, double target) const;

    CurveOnSurface m_on_surface;
    const AnalyticSurface *m_form;
    std::optional<AnalyticCurve> m_pcurve;
};

//! Largest distance seen between a curve and a pcurve's points, over samples dense in both.
double largest_distance(const Handle(Geom_Curve) & curve, const CurveOnSurface &on_surface);

} // namespace laminate_offset
