// SPDX-License-Identifier: LGPL-2.1-or-later
#include "creases.h"

#include "../input/loop_gaps.h"

#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeExtend_CompositeSurface.hxx>
#include <ShapeFix_ComposeShell.hxx>
#include <Standard_Failure.hxx>
#include <TColGeom_HArray2OfSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace laminate_offset
{
namespace
{

// How far the parts' loops may stray over a crease, as part of the box: pcurves miss their line by less.
constexpr double straying = 1e-6;
// Relative difference between the parameter areas of the face and of its parts: that of chords to curves.
constexpr double area_agreement = 1e-5;
constexpr int area_chords = 2000;

//! The area that the loops enclose in the parameters.
double parameter_area(const InputFace &input)
{
    double area = 0.0;
    for (const TrimmingLoop &loop : input.loops)
        for (const TrimmingCurve &curve : loop.curves)
        {
            if (!curve.bounds_face())
                continue;
            double part = 0.0;
            gp_XY before = curve.pcurve->Value(curve.first).XY();
            for (int i = 1; i <= area_chords; ++i)
            {
                const double t = curve.first + (curve.last - curve.first) * i / area_chords;
                const gp_XY here = curve.pcurve->Value(t).XY();
                part += 0.5 * before.Crossed(here);
                before = here;
            }
            area += curve.edge.Orientation() == TopAbs_REVERSED ? -part : part;
        }
    return std::abs(area);
}

//! A profile with a kink has two tangents there, of which OpenCASCADE knows one: the part gets its own profile.
Handle(Geom_Surface) own_profile(const Handle(Geom_Surface) & surface, const ParameterBox &box)
{
    const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
    if (revolution.IsNull())
        return surface;
    Handle(Geom_Curve) profile = revolution->BasisCurve();
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(profile))
        profile = trimmed->BasisCurve();
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(profile);
    if (spline.IsNull() || spline->IsPeriodic())
        return surface;
    const auto own = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    own->Segment(std::max(box.vmin, own->FirstParameter()), std::min(box.vmax, own->LastParameter()));
    return new Geom_SurfaceOfRevolution(own, revolution->Axis());
}

//! Does the box lie on one side of every crease?
bool is_uncreased(const ParameterBox &box, const std::vector<CreaseLine> &creases)
{
    return std::none_of(creases.begin(), creases.end(), [&](const CreaseLine &line) {
        const double low = line.constant_u ? box.umin : box.vmin;
        const double high = line.constant_u ? box.umax : box.vmax;
        const double slack = straying * (high - low);
        return low < line.parameter - slack && high > line.parameter + slack;
    });
}

Result<InputFace> read_part(const InputFace &input, const TopoDS_Face &part)
{
    constexpr bool refuse_mirrors = false; // the base may stand under a mirror
    TopoDS_Face placed = TopoDS::Face(part.Oriented(input.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
    placed.Location(input.location, refuse_mirrors);
    Result<InputFace> read = read_face(placed);
    if (!read)
        return read;
    read.value().surface = own_profile(read.value().surface, read.value().box);
    read.value().base_distance = input.base_distance;
    return read;
}

//! The ends of the creases' cells in one direction.
TColStd_Array1OfReal cell_ends(double low, double high, const std::vector<CreaseLine> &creases, bool of_u)
{
    std::vector<double> ends{low};
    for (const CreaseLine &line : creases) // in increasing order
        if (line.constant_u == of_u)
            ends.push_back(line.parameter);
    ends.push_back(high);
    TColStd_Array1OfReal result(1, static_cast<int>(ends.size()));
    for (std::size_t i = 0; i < ends.size(); ++i)
        result(static_cast<int>(i) + 1) = ends[i];
    return result;
}

//! A loop's wire with its edges one after the other. In a wire a sweep leaves them as it made them, both circles of a ring
//! before both of its seams, and ShapeFix_ComposeShell goes by the order.
TopoDS_Wire in_sequence(const InputFace &input, const TrimmingLoop &loop)
{
    const std::vector<std::size_t> next = following_curves(input, loop, curve_ends(loop));
    std::vector<TopoDS_Edge> edges, others;
    for (const TrimmingCurve &curve : loop.curves)
        (curve.bounds_face() ? edges : others).push_back(curve.edge);
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    std::vector<char> done(edges.size(), 0);
    for (std::size_t start = 0; start < edges.size(); ++start)
        for (std::size_t i = start; done[i] == 0; i = next[i])
        {
            builder.Add(wire, edges[i]);
            done[i] = 1;
        }
    for (const TopoDS_Edge &edge : others)
        builder.Add(wire, edge);
    wire.Closed(true);
    return wire;
}

TopoDS_Face in_sequence(const InputFace &input)
{
    TopoDS_Face face = TopoDS::Face(input.face.EmptyCopied());
    for (const TrimmingLoop &loop : input.loops)
        BRep_Builder().Add(face, in_sequence(input, loop));
    return face;
}

//! Splits along the borders of the creases' cells, in the parameters alone.
TopoDS_Shape split(const InputFace &input, const std::vector<CreaseLine> &creases)
{
    const ParameterBox box = fit_box(input);
    const TColStd_Array1OfReal us = cell_ends(box.umin, box.umax, creases, true);
    const TColStd_Array1OfReal vs = cell_ends(box.vmin, box.vmax, creases, false);
    const Handle(TColGeom_HArray2OfSurface) cells =
        new TColGeom_HArray2OfSurface(1, us.Length() - 1, 1, vs.Length() - 1);
    for (int i = 1; i < us.Length(); ++i)
        for (int j = 1; j < vs.Length(); ++j)
            cells->SetValue(i, j,
                            new Geom_RectangularTrimmedSurface(input.surface, us(i), us(i + 1), vs(j), vs(j + 1)));
    const Handle(ShapeExtend_CompositeSurface) grid = new ShapeExtend_CompositeSurface;
    if (!grid->Init(cells, us, vs))
        return {};
    ShapeFix_ComposeShell composer;
    composer.Init(grid, TopLoc_Location(), in_sequence(input), Precision::Confusion());
    composer.SetContext(new ShapeBuild_ReShape);
    composer.SetMaxTolerance(std::max(input.tolerance, Precision::Confusion()));
    return composer.Perform() ? composer.Result() : TopoDS_Shape();
}

//! The parts, as far as they make up the face and no crease goes through them.
std::optional<std::vector<InputFace>> split_parts(const InputFace &input, const std::vector<CreaseLine> &creases)
{
    const TopoDS_Shape shape = split(input, creases);
    if (shape.IsNull())
        return std::nullopt;
    std::vector<InputFace> parts;
    double area = 0.0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    {
        Result<InputFace> part = read_part(input, TopoDS::Face(it.Current()));
        if (!part || !is_uncreased(part.value().box, creases))
            return std::nullopt;
        area += parameter_area(part.value());
        parts.push_back(std::move(part).value());
    }
    const double whole = parameter_area(input);
    if (parts.size() < 2 || std::abs(area - whole) > area_agreement * whole)
        return std::nullopt;
    std::stable_sort(parts.begin(), parts.end(), [](const InputFace &a, const InputFace &b) {
        return std::tie(a.box.umin, a.box.vmin) < std::tie(b.box.umin, b.box.vmin);
    });
    return parts;
}

} // namespace

Result<std::vector<InputFace>> split_at_creases(const InputFace &input, double distance, double tolerance)
{
    const double farther = farther_distance(input, distance);
    const BaseSurface base = base_beside_creases(input, {farther, tolerance});
    const std::vector<CreaseLine> creases = find_creases(input, base, LoopRegion(input), farther, tolerance);
    if (creases.empty())
        return std::vector<InputFace>{input};
    try
    {
        if (std::optional<std::vector<InputFace>> parts = split_parts(input, creases))
            return *std::move(parts);
    }
    catch (const Standard_Failure &)
    {
        return creased_refusal(input, creases); // the split is out of OpenCASCADE's reach
    }
    return creased_refusal(input, creases);
}

} // namespace laminate_offset
