// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tensor_spline.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace laminate_offset
{
namespace
{

using Columns = std::vector<Eigen::Vector4d>;

//! Contracts the poles over u at one row of basis values: one homogeneous point for each v pole.
void contract_u(const TensorSpline &spline, const double *basis, int first, Columns &out)
{
    const int count = spline.v.pole_count();
    std::fill(out.begin(), out.end(), Eigen::Vector4d::Zero());
    for (int i = 0; i <= spline.u.degree; ++i)
        for (int j = 0; j < count; ++j)
            out[static_cast<std::size_t>(j)] += basis[i] * spline.pole(first + i, j);
}

Eigen::Vector4d contract_v(const Columns &columns, const double *basis, int first, int width)
{
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int j = 0; j < width; ++j)
        sum += basis[j] * columns[static_cast<std::size_t>(first) + j];
    return sum;
}

//! From homogeneous derivatives to those of the projected surface (NURBS Book A4.4).
void project(const std::array<Eigen::Vector4d, 6> &h, int order, SurfaceJet &jet)
{
    const double w = h[0].w();
    jet.s = h[0].head<3>() / w;
    if (order < 1)
        return;
    jet.u = (h[1].head<3>() - h[1].w() * jet.s) / w;
    jet.v = (h[2].head<3>() - h[2].w() * jet.s) / w;
    if (order < 2)
        return;
    jet.uu = (h[3].head<3>() - 2.0 * h[1].w() * jet.u - h[3].w() * jet.s) / w;
    jet.uv = (h[4].head<3>() - h[1].w() * jet.v - h[2].w() * jet.u - h[4].w() * jet.s) / w;
    jet.vv = (h[5].head<3>() - 2.0 * h[2].w() * jet.v - h[5].w() * jet.s) / w;
}

std::vector<double> flat_knots(const TColStd_Array1OfReal &sequence)
{
    std::vector<double> knots;
    for (int i = sequence.Lower(); i <= sequence.Upper(); ++i)
        knots.push_back(sequence(i));
    return knots;
}

struct KnotArrays
{
    TColStd_Array1OfReal parameters;
    TColStd_Array1OfInteger multiplicities;

    explicit KnotArrays(const std::vector<Knot> &knots)
        : parameters(1, static_cast<int>(knots.size())), multiplicities(1, static_cast<int>(knots.size()))
    {
        for (std::size_t i = 0; i < knots.size(); ++i)
        {
            parameters(static_cast<int>(i) + 1) = knots[i].parameter;
            multiplicities(static_cast<int>(i) + 1) = knots[i].multiplicity;
        }
    }
};

//! OpenCASCADE admits end knots of less than full multiplicity; the numerics here do not.
void clamp_ends(Geom_BSplineSurface &surface)
{
    const bool u = surface.UMultiplicity(surface.FirstUKnotIndex()) <= surface.UDegree() ||
                   surface.UMultiplicity(surface.LastUKnotIndex()) <= surface.UDegree();
    const bool v = surface.VMultiplicity(surface.FirstVKnotIndex()) <= surface.VDegree() ||
                   surface.VMultiplicity(surface.LastVKnotIndex()) <= surface.VDegree();
    if (!u && !v)
        return;
    double u0, u1, v0, v1;
    surface.Bounds(u0, u1, v0, v1);
    surface.Segment(u0, u1, v0, v1);
}

bool weights_differ(const Geom_BSplineSurface &surface)
{
    const double first = surface.Weight(1, 1);
    for (int i = 1; i <= surface.NbUPoles(); ++i)
        for (int j = 1; j <= surface.NbVPoles(); ++j)
            if (surface.Weight(i, j) != first)
                return true;
    return false;
}

} // namespace

std::vector<SurfaceJet> TensorSpline::jets(const std::vector<double> &us, const std::vector<double> &vs,
                                           int order) const
{
    // derivative pairs (du, dv) in the jet's order; the first 1, 3 or 6 are needed
    constexpr std::array<std::array<int, 2>, 6> pairs{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    constexpr std::array<std::size_t, 3> needed{1, 3, 6};
    const BasisRows rows_u(u, us, order);
    const BasisRows rows_v(v, vs, order);
    std::vector<SurfaceJet> result(us.size() * vs.size());
    const auto evaluate = [&](const tbb::blocked_range<std::size_t> &range) {
        std::array<Columns, 3> columns;
        columns.fill(Columns(static_cast<std::size_t>(v.pole_count())));
        std::array<Eigen::Vector4d, 6> h;
        for (std::size_t k = range.begin(); k < range.end(); ++k)
        {
            const int row = static_cast<int>(k);
            for (int d = 0; d <= order; ++d)
                contract_u(*this, rows_u.row(row, d), rows_u.first(row), columns[static_cast<std::size_t>(d)]);
            for (std::size_t l = 0; l < vs.size(); ++l)
            {
                const int column = static_cast<int>(l);
                for (std::size_t e = 0; e < needed[static_cast<std::size_t>(order)]; ++e)
                    h[e] = contract_v(columns[static_cast<std::size_t>(pairs[e][0])], rows_v.row(column, pairs[e][1]),
                                      rows_v.first(column), rows_v.width());
                project(h, order, result[k * vs.size() + l]);
            }
        }
    };
    const tbb::blocked_range<std::size_t> rows(0, us.size(), std::max<std::size_t>(1, 4096 / (vs.size() + 1)));
    if (rows.is_divisible())
        tbb::parallel_for(rows, evaluate);
    else
        evaluate(rows);
    return result;
}

std::vector<double> TensorSpline::weights(const std::vector<double> &us, const std::vector<double> &vs) const
{
    const BasisRows rows_u(u, us);
    const BasisRows rows_v(v, vs);
    Columns columns(static_cast<std::size_t>(v.pole_count()));
    std::vector<double> result;
    result.reserve(us.size() * vs.size());
    for (int k = 0; k < rows_u.rows(); ++k)
    {
        contract_u(*this, rows_u.row(k), rows_u.first(k), columns);
        for (int l = 0; l < rows_v.rows(); ++l)
            result.push_back(contract_v(columns, rows_v.row(l), rows_v.first(l), rows_v.width()).w());
    }
    return result;
}

TensorSpline from_geom(const Handle(Geom_BSplineSurface) & surface)
{
    Handle(Geom_BSplineSurface) clamped = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    if (clamped->IsUPeriodic())
        clamped->SetUNotPeriodic();
    if (clamped->IsVPeriodic())
        clamped->SetVNotPeriodic();
    clamp_ends(*clamped);
    TensorSpline spline;
    spline.u = {clamped->UDegree(), flat_knots(clamped->UKnotSequence())};
    spline.v = {clamped->VDegree(), flat_knots(clamped->VKnotSequence())};
    spline.rational = (clamped->IsURational() || clamped->IsVRational()) && weights_differ(*clamped);
    for (int i = 1; i <= clamped->NbUPoles(); ++i)
        for (int j = 1; j <= clamped->NbVPoles(); ++j)
        {
            const gp_Pnt p = clamped->Pole(i, j);
            const double w = spline.rational ? clamped->Weight(i, j) : 1.0;
            spline.poles.emplace_back(w * p.X(), w * p.Y(), w * p.Z(), w);
        }
    return spline;
}

Handle(Geom_BSplineSurface) to_geom(const TensorSpline &spline)
{
    const int nu = spline.u.pole_count();
    const int nv = spline.v.pole_count();
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    TColStd_Array2OfReal weights(1, nu, 1, nv);
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
        {
            const Eigen::Vector4d &p = spline.pole(i, j);
            poles(i + 1, j + 1).SetCoord(p.x() / p.w(), p.y() / p.w(), p.z() / p.w());
            weights(i + 1, j + 1) = p.w();
        }
    const KnotArrays u(spline.u.distinct());
    const KnotArrays v(spline.v.distinct());
    if (!spline.rational)
        return new Geom_BSplineSurface(poles, u.parameters, v.parameters, u.multiplicities, v.multiplicities,
                                       spline.u.degree, spline.v.degree);
    return new Geom_BSplineSurface(poles, weights, u.parameters, v.parameters, u.multiplicities, v.multiplicities,
                                   spline.u.degree, spline.v.degree);
}

} // namespace laminate_offset
