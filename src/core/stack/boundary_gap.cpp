// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boundary_gap.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_BSplineCurve.hxx>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int samples_per_span = 8;
constexpr int least_samples = 64;
constexpr double usual_share = 0.25;
constexpr double least_gap = 1.0; // [mm]

int sample_count(const Handle(Geom2d_Curve) & image)
{
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(image);
    return std::max(least_samples, spline.IsNull() ? 0 : samples_per_span * (spline->NbKnots() - 1));
}

} // namespace

BoundaryGap boundary_gap(const InputFace &input, const LoopRegion &inside, const std::vector<DroppedCurve> &curves)
{
    BoundaryGap gap;
    for (const DroppedCurve &dropped : curves)
    {
        const int count = sample_count(dropped.image);
        for (int i = 0; i <= count; ++i)
        {
            const double t = dropped.first + (dropped.last - dropped.first) * i / count;
            const gp_Pnt2d uv = dropped.image->Value(t);
            if (!inside.contains(uv))
                continue;
            const double distance = dropped.curve->Value(t).Distance(input.point(uv));
            if (!gap.where || distance > gap.distance)
                gap = {distance, input.place(uv)};
        }
    }
    return gap;
}

double usual_gap(const InputFace &input, const TopoDS_Shape &boundary)
{
    constexpr bool by_mesh = false;
    constexpr bool with_tolerances = false;
    Bnd_Box box;
    BRepBndLib::AddOptimal(boundary, box, by_mesh, with_tolerances);
    const double size = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
    return std::max(least_gap, usual_share * std::min(size, input.diagonal));
}

} // namespace laminate_offset
