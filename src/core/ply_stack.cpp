// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_stack.h"

#include "project_curve.h"

#include "analysis/surface_analysis.h"
#include "input/input_face.h"
#include "report/face_report.h"
#include "stack/boundary_gap.h"
#include "stack/boundary_inset.h"
#include "stack/boundary_sides.h"
#include "stack/moved_seam.h"
#include "stack/ply_levels.h"
#include "topology/build_face.h"
#include "trimming/check_edges.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <utility>

namespace laminate_offset
{
namespace
{

constexpr double least_ratio = 1.0;
constexpr double most_ratio = 1000.0;
// Of the tolerance: how near an image has to be to its curve so that its direction is right as well.
constexpr double direction_share = 0.02;
// A ramp that is bound by its steepest slope is so much longer at most, as a rule.
constexpr double most_growth = 2.0;

Failure option_refusal(std::string message)
{
    return {Status::InvalidOption, Stage::Options, std::move(message), std::nullopt, std::nullopt};
}

//! The failure with the boundary's name in front.
Failure about(const PlyBoundary &boundary, Failure failure)
{
    failure.message = fmt::format("Boundary '{}': {}", boundary.name, failure.message);
    return failure;
}

Result<bool> checked(const std::vector<PlySpec> &plies, const std::vector<PlyBoundary> &boundaries,
                     const PlyStackOptions &options)
{
    OffsetOptions common;
    common.tolerance = options.tolerance;
    common.max_degree = options.max_degree;
    if (Result<bool> ok = check(common); !ok)
        return ok;
    if (plies.empty())
        return option_refusal("A stack needs one ply at least; give the plies with their thicknesses.");
    for (const PlySpec &ply : plies)
        if (!(ply.thickness > 0.0 && std::isfinite(ply.thickness)))
            return option_refusal("Every ply's thickness must be a finite number of mm above zero.");
        else if (ply.boundary && *ply.boundary >= boundaries.size())
            return option_refusal("A ply names a boundary that is not there; give all boundaries.");
        else if (!(ply.inset >= 0.0 && std::isfinite(ply.inset)) || (ply.inset > 0.0 && !ply.boundary))
            return option_refusal("An inset must be a finite number of mm, zero or more, of a ply with a boundary.");
        else if (ply.inset > 0.0 && boundaries[*ply.boundary].side == PlySide::Nearest)
            return option_refusal(
                "An inset needs a boundary with a side: inside, outside, left or right, not a point.");
    if (std::abs(options.direction) != 1.0)
        return option_refusal("The direction must be 1 (along the face's outward normal) or -1 (against it).");
    if (!std::isfinite(options.start))
        return Failure{Status::InvalidDistance, Stage::Options, "The start of the stack is not a finite number of mm.",
                       std::nullopt, std::nullopt};
    if (!(options.ratio >= least_ratio && options.ratio <= most_ratio))
        return option_refusal(fmt::format("The ratio of a ramp's length to the thickness must be from {} to {}.",
                                          least_ratio, most_ratio));
    if (options.ramp_length && !(*options.ramp_length > 0.0 && std::isfinite(*options.ramp_length)))
        return option_refusal("A ramp's length must be a finite number of mm above zero.");
    if (options.boundary_gap && !(*options.boundary_gap >= 0.0 && std::isfinite(*options.boundary_gap)))
        return option_refusal("The gap of boundaries must be a finite number of mm, zero or more.");
    return true;
}

//! A boundary put onto the face.
class BoundaryOnFace
{
public:
    BoundaryOnFace(const TopoDS_Shape &face, const InputFace &input, const PlyBoundary &boundary,
                   const PlyStackOptions &options)
        : m_face(face), m_input(input), m_boundary(boundary), m_tolerance(options.tolerance),
          m_most_gap(options.boundary_gap.value_or(usual_gap(input, boundary.shape)))
    {
    }

    //! \param inset how far the ply's edge keeps inside of the boundary [mm].
    //! \param result its inset_error becomes the larger of itself and what was seen of the moved curves' error.
    //! \param gap becomes the boundary's distance from the face [mm].
    Result<PlyRegion> region(double inset, PlyStackResult &result, std::optional<double> &gap) const
    {
        const std::vector<TopoDS_Wire> wires = boundary_wires(m_boundary.shape);
        if (wires.empty())
            return option_refusal("There is no curve in it; give an edge, a wire or a face.");
        std::vector<TopoDS_Shape> on_face;
        std::vector<DroppedCurve> dropped;
        for (const TopoDS_Wire &wire : wires)
        {
            // the directions across an image count where it is moved
            const double near = inset > 0.0 ? direction_share * m_tolerance : m_tolerance;
            const Result<CurveProjection> projection = project_curve(m_face, wire, {near, Outside::Clip});
            if (!projection)
                return projection.failure();
            on_face.push_back(projection.value().wire.Located(TopLoc_Location()));
            for (const ProjectedEdge &edge : projection.value().edges)
                dropped.push_back({edge.given, edge.pcurve, edge.first, edge.last});
        }
        const BoundaryGap found = boundary_gap(m_input, LoopRegion(m_input), dropped);
        if (found.distance > m_most_gap + m_tolerance) // the image itself may be off by the tolerance
            return too_far(found);
        gap = found.distance;
        const Result<std::vector<bool>> left = sides(wires, on_face);
        if (!left)
            return left.failure();
        std::vector<BoundaryImage> images;
        for (std::size_t k = 0; k < wires.size(); ++k)
        {
            BoundaryImage image{on_face[k], left.value()[k]};
            if (inset > 0.0)
            {
                const Result<BoundaryInset> moved = inset_boundary(m_input, image, inset, m_tolerance);
                if (!moved)
                    return moved.failure();
                image = moved.value().image;
                result.inset_error = std::max(result.inset_error, moved.value().error);
            }
            images.push_back(std::move(image));
        }
        if (m_boundary.side == PlySide::Nearest)
            return cut_region(m_input, images,
                              m_boundary.point.Transformed(m_input.location.Transformation().Inverted()));
        return cut_region(m_input, images);
    }

private:
    [[nodiscard]] Failure too_far(const BoundaryGap &gap) const
    {
        return {Status::NotSupported, Stage::Trimming,
                fmt::format("It stands {:.4g} mm from the face, more than {:.4g} mm, so its image may not be what was "
                            "meant; draw it nearer to the face, or allow a boundary gap of {:.4g} mm.",
                            gap.distance, m_most_gap, 1.01 * gap.distance),
                gap.where, std::nullopt};
    }

    //! Whether the ply lies left of each wire, with S_u x S_v upwards.
    [[nodiscard]] Result<std::vector<bool>> sides(const std::vector<TopoDS_Wire> &wires,
                                                  const std::vector<TopoDS_Shape> &images) const
    {
        if (m_boundary.side == PlySide::Left || m_boundary.side == PlySide::Right)
            return std::vector<bool>(wires.size(), (m_boundary.side == PlySide::Left) == (m_input.normal_sign > 0.0));
        if (m_boundary.side == PlySide::Nearest)
            return std::vector<bool>(wires.size(), true);
        Result<std::vector<bool>> left = inside_is_left(m_input, wires, images);
        if (left && m_boundary.side == PlySide::Outside)
            left.value().flip();
        return left;
    }

    const TopoDS_Shape &m_face;
    const InputFace &m_input;
    const PlyBoundary &m_boundary;
    double m_tolerance;
    double m_most_gap; //!< [mm]
};

class PlyPipeline
{
public:
    PlyPipeline(const TopoDS_Shape &face, const std::vector<PlySpec> &plies, const std::vector<PlyBoundary> &boundaries,
                const PlyStackOptions &options)
        : m_face(face), m_plies(plies), m_boundaries(boundaries), m_options(options)
    {
    }

    Result<PlyStackResult> run()
    {
        const Result<InputFace> input = read_face(m_face);
        if (!input)
            return input.failure();
        Result<std::vector<PlyRegion>> regions = all_regions(input.value());
        if (!regions)
            return regions.failure();
        const Result<PlyLevels> levels =
            ply_levels(input.value(), stacking(input.value()), regions.value(), fit_options());
        if (!levels)
            return levels.failure();
        for (const AddedRamps &added : levels.value().added)
            m_result.steep_ramps.push_back(
                {added.slope, added.alone, input.value().place(added.uv), added.longest, added.plies});
        return faces(regions.value(), levels.value());
    }

private:
    [[nodiscard]] OffsetOptions fit_options() const
    {
        OffsetOptions options;
        options.tolerance = m_options.tolerance;
        options.max_degree = m_options.max_degree;
        if (m_options.progress)
            options.progress = [outer = m_options.progress](double fraction) { return outer(0.7 * fraction); };
        return options;
    }

    //! One region for every boundary and inset that a ply has.
    Result<std::vector<PlyRegion>> all_regions(const InputFace &input)
    {
        std::vector<PlyRegion> regions;
        m_result.boundary_gaps.resize(m_boundaries.size());
        std::vector<std::pair<std::size_t, double>> known;
        for (const PlySpec &ply : m_plies)
        {
            const auto key = std::make_pair(ply.boundary.value_or(m_boundaries.size()), ply.inset);
            const auto at = std::find(known.begin(), known.end(), key);
            m_region_of.push_back(static_cast<std::size_t>(at - known.begin()));
            if (at != known.end())
                continue;
            known.push_back(key);
            if (!ply.boundary)
            {
                regions.push_back(whole_region(input));
                continue;
            }
            const PlyBoundary &boundary = m_boundaries[*ply.boundary];
            Result<PlyRegion> region = BoundaryOnFace(m_face, input, boundary, m_options)
                                           .region(ply.inset, m_result, m_result.boundary_gaps[*ply.boundary]);
            if (!region)
                return about(boundary, region.failure());
            region.value().name = boundary.name;
            regions.push_back(std::move(region).value());
        }
        return regions;
    }

    [[nodiscard]] Stacking stacking(const InputFace &input) const
    {
        Stacking result;
        result.start = input.from_surface(m_options.start);
        result.middle = m_options.middle;
        result.steepest = m_options.ramp_slope == RampSlope::Steepest;
        for (std::size_t k = 0; k < m_plies.size(); ++k)
            result.plies.push_back({input.normal_sign * m_options.direction * m_plies[k].thickness, m_region_of[k],
                                    m_options.ramp_length.value_or(m_options.ratio * m_plies[k].thickness)});
        return result;
    }

    //! All faces of all plies, in parallel.
    Result<PlyStackResult> faces(const std::vector<PlyRegion> &regions, const PlyLevels &levels)
    {
        const std::size_t each = m_options.middle ? 3 : 2;
        std::vector<std::optional<Result<PlySurface>>> made(each * m_plies.size());
        std::atomic<std::size_t> done{0};
        std::atomic<bool> cancelled{false};
        std::mutex guard;
        tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
            if (cancelled)
                return;
            const std::size_t ply = i / each;
            made[i] = face_of(regions, m_region_of[ply], levels, levels.of(ply, i % each, m_options.middle));
            const double fraction = 0.7 + 0.3 * static_cast<double>(++done) / static_cast<double>(made.size());
            const std::lock_guard lock(guard);
            if (m_options.progress && !m_options.progress(fraction))
                cancelled = true;
        });
        if (cancelled)
            return Failure{Status::Cancelled, Stage::Topology,
                           "The computation was cancelled while the plies' faces were made.", std::nullopt,
                           std::nullopt};
        for (std::size_t i = 0; i < made.size(); ++i)
            if (!made[i]->ok())
                return made[i]->failure();
        for (std::size_t k = 0; k < m_plies.size(); ++k)
        {
            const auto surface = [&](std::size_t which) { return made[each * k + which]->value(); };
            const PlyRegion &region = regions[m_region_of[k]];
            StackedPly ply{located(region.input),
                           bottom_distance(levels, k),
                           region.input.normal_sign * m_options.direction * m_plies[k].thickness,
                           ramp_figures(levels.ramps[k], m_plies[k].thickness),
                           surface(0),
                           std::nullopt,
                           surface(each - 1)};
            if (m_options.middle)
                ply.middle = surface(1);
            m_result.plies.push_back(std::move(ply));
        }
        return std::move(m_result);
    }

    static std::optional<RampFigures> ramp_figures(const std::optional<PlyRamp> &ramp, double thickness)
    {
        if (!ramp)
            return std::nullopt;
        return RampFigures{ramp->length, thickness / ramp->length, thickness * ramp->steepest};
    }

    static std::shared_ptr<const ScalarSpline> bottom_distance(const PlyLevels &levels, std::size_t ply)
    {
        const PlyLevel &bottom = levels.between[ply];
        const ParameterBox &box = levels.analysis.base.box();
        return std::make_shared<const ScalarSpline>(
            bottom.distance ? *bottom.distance
                            : ScalarSpline::constant(bottom.constant, box.umin, box.umax, box.vmin, box.vmax));
    }

    static TopoDS_Face located(const InputFace &input)
    {
        constexpr bool refuse_mirrors = false;
        TopoDS_Shape face = input.face.Oriented(input.reversed ? TopAbs_REVERSED : TopAbs_FORWARD);
        face.Location(input.location, refuse_mirrors);
        return TopoDS::Face(face);
    }

    //! Does the surface's distance vary on the ply itself?
    static bool varies(const LoopRegion &inside, const PlyLevel &level)
    {
        return level.distance && !level.distance->constant_where([&](double u0, double u1, double v0, double v1) {
            return inside.may_touch({u0, u1, v0, v1});
        });
    }

    [[nodiscard]] Result<PlySurface> face_of(const std::vector<PlyRegion> &regions, std::size_t which,
                                             const PlyLevels &levels, const PlyLevel &level) const
    {
        const PlyRegion &region = regions[which];
        try
        {
            const Result<TrimLoops> loops =
                offset_loops({region.input, levels.analysis.base, level.surface, level.nominal,
                              edge_share * m_options.tolerance, level.distance ? &*level.distance : nullptr});
            if (!loops)
                return loops.failure();
            if (const Result<bool> near = check_edges(region.input, level.surface, loops.value(), m_options.tolerance);
                !near)
                return near.failure();
            const Result<TopoDS_Face> face = build_face(region.input, level.surface, loops.value());
            if (!face)
                return face.failure();
            OffsetOptions options = fit_options();
            options.distance = region.input.from_face(level.nominal);
            return PlySurface{
                {face.value(), face_report(region.input, levels.analysis, level.surface, loops.value(), options)},
                varies(levels.inside[which], level)};
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, Stage::Topology);
        }
    }

    const TopoDS_Shape &m_face;
    const std::vector<PlySpec> &m_plies;
    const std::vector<PlyBoundary> &m_boundaries;
    const PlyStackOptions &m_options;
    std::vector<std::size_t> m_region_of; //!< of each ply
    PlyStackResult m_result;
};

//! The face with its seam out of the way of boundaries; empty where it is in nobody's way.
std::optional<TopoDS_Face> out_of_the_way(const TopoDS_Shape &face, const InputFace &input,
                                          const std::vector<PlySpec> &plies, const std::vector<PlyBoundary> &boundaries,
                                          const PlyStackOptions &options)
{
    if (!has_seam(input))
        return std::nullopt;
    std::vector<TopoDS_Shape> images;
    double clearance = 0.0;
    for (const PlySpec &ply : plies)
        if (ply.boundary)
        {
            const double longer = options.ramp_slope == RampSlope::Steepest ? most_growth : 1.0;
            clearance =
                std::max(clearance, ply.inset + longer * options.ramp_length.value_or(options.ratio * ply.thickness));
            for (const TopoDS_Wire &wire : boundary_wires(boundaries[*ply.boundary].shape))
                if (const auto image = project_curve(face, wire, {options.tolerance, Outside::Clip}))
                    images.push_back(image.value().wire.Located(TopLoc_Location()));
        }
    return with_moved_seam(input, images, clearance);
}

//! What can be said before any curve is dropped onto the face: on a creased one images and insets fail for reasons that
//! lead nobody to the crease.
Result<InputFace> readable(const TopoDS_Shape &face, const std::vector<PlySpec> &plies,
                           const std::vector<PlyBoundary> &boundaries, const PlyStackOptions &options)
{
    if (const Result<bool> ok = checked(plies, boundaries, options); !ok)
        return ok.failure();
    Result<InputFace> input = read_face(face);
    if (!input)
        return input;
    double top = options.start;
    for (const PlySpec &ply : plies)
        top += options.direction * ply.thickness;
    const double start = input.value().from_surface(options.start), end = input.value().from_surface(top);
    const double farthest = std::abs(start) > std::abs(end) ? start : end;
    if (const Result<bool> smooth = check_uncreased(input.value(), farthest, options.tolerance); !smooth)
        return smooth.failure();
    return input;
}

} // namespace

Result<PlyStackResult> stack_plies(const TopoDS_Shape &face, const std::vector<PlySpec> &plies,
                                   const std::vector<PlyBoundary> &boundaries, const PlyStackOptions &options)
{
    const auto start = std::chrono::steady_clock::now();
    try
    {
        const Result<InputFace> input = readable(face, plies, boundaries, options);
        if (!input)
            return input.failure();
        const std::optional<TopoDS_Face> moved = out_of_the_way(face, input.value(), plies, boundaries, options);
        const TopoDS_Shape lay_up = moved ? TopoDS_Shape(*moved) : face;
        Result<PlyStackResult> result = PlyPipeline(lay_up, plies, boundaries, options).run();
        if (result)
            result.value().moved_seam = moved;
        if (result)
            result.value().elapsed =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        return result;
    }
    catch (const Standard_Failure &error)
    {
        return kernel_failure(error, Stage::Trimming);
    }
}

} // namespace laminate_offset
