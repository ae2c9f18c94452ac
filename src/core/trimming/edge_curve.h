// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! The curve in space of one pcurve on the offset surface.
#pragma once

#include "analytic_curve.h"
#include "analytic_surface.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <optional>

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

struct EdgeCurve
{
    Handle(Geom_Curve) curve;
    Deviation deviation;
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

    //! Deviation of a curve with the pcurve's parameters, proven wherever that is possible.
    //! \param target how small the bound has to be [mm].
    [[nodiscard]] Deviation deviation(const Handle(Geom_Curve) & curve, double target) const;
    //! The same of a single point.
    [[nodiscard]] Deviation deviation(const gp_Pnt &point, double target) const;

private:
    [[nodiscard]] std::optional<double> proven(const std::optional<AnalyticCurve> &curve, double target) const;

    CurveOnSurface m_on_surface;
    const AnalyticSurface *m_form;
    std::optional<AnalyticCurve> m_pcurve;
};

//! The exact curve of an isoparametric pcurve (a line, a circle, a B-spline's own isoparametric curve) and of any pcurve
//! on a plane.
//! \return nothing for any other pcurve, or where rounding exceeds the tolerance [mm].
std::optional<EdgeCurve> exact_curve(const EdgeTarget &target, double tolerance);

//! Isoparametric pcurves give an exact curve (a line, a circle, a B-spline's own isoparametric curve), all
//! pcurves on a plane too; any other pcurve is fitted with few poles. The curve has the pcurve's
//! parameters.
//! \param like a curve whose knots and weights are taken where they serve; null for none.
//! \return nothing when the tolerance [mm] cannot be reached.
std::optional<EdgeCurve> edge_curve(const EdgeTarget &target, double tolerance,
                                    const Handle(Geom_Curve) &like = nullptr);

//! Largest distance seen between a curve and a pcurve's points, over samples dense in both.
double largest_distance(const Handle(Geom_Curve) & curve, const CurveOnSurface &on_surface);

} // namespace laminate_offset
