// SPDX-License-Identifier: LGPL-2.1-or-later
#include "same_knots.h"

#include "../spline/geom_values.h"
#include "../spline/knot_choice.h"
#include "../spline/least_squares.h"

namespace laminate_offset
{
namespace
{

constexpr int spare_samples = 3;

//! The weight function of a curve.
double weight_at(const KnotVector &kv, const Geom_BSplineCurve &curve, double t)
{
    double basis[max_spline_degree + 1];
    const int span = kv.span(t);
    basis_values(kv, span, t, basis);
    double sum = 0.0;
    for (int i = 0; i <= kv.degree; ++i)
        sum += basis[i] * curve.Weight(span - kv.degree + i + 1);
    return sum;
}

} // namespace

bool clamped(const Geom_BSplineCurve &curve)
{
    return !curve.IsPeriodic() && curve.Multiplicity(1) == curve.Degree() + 1 &&
           curve.Multiplicity(curve.NbKnots()) == curve.Degree() + 1;
}

bool on_same_knots(const Geom_BSplineCurve &a, const Geom_BSplineCurve &b)
{
    if (a.Degree() != b.Degree() || a.NbKnots() != b.NbKnots() || a.NbPoles() != b.NbPoles())
        return false;
    for (int i = 1; i <= a.NbKnots(); ++i)
        if (a.Knot(i) != b.Knot(i) || a.Multiplicity(i) != b.Multiplicity(i))
            return false;
    for (int i = 1; i <= a.NbPoles(); ++i)
        if (a.Weight(i) != b.Weight(i))
            return false;
    return true;
}

Handle(Geom_BSplineCurve) through_samples(const Geom_BSplineCurve &pattern, const EdgeTarget &target)
{
    const KnotVector kv = knots_of(pattern);
    const std::vector<double> parameters = chebyshev_parameters(kv.breaks(), kv.degree + spare_samples);
    const auto solver = LeastSquaresFit::make(kv, parameters);
    if (!solver)
        return {};
    const Eigen::Vector3d origin = target.value(0.5 * (kv.front() + kv.back()));
    RowMatrix rows = target.values(parameters, origin);
    if (pattern.IsRational())
        for (std::size_t i = 0; i < parameters.size(); ++i)
            rows.row(static_cast<Eigen::Index>(i)) *= weight_at(kv, pattern, parameters[i]);
    const RowMatrix poles = solver->solve(rows);
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(pattern.Copy());
    for (int i = 1; i <= curve->NbPoles(); ++i)
    {
        const Eigen::Vector3d pole = origin + poles.row(i - 1).transpose() / pattern.Weight(i);
        curve->SetPole(i, gp_Pnt(pole.x(), pole.y(), pole.z()));
    }
    return curve;
}

} // namespace laminate_offset
