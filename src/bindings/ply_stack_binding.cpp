// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_stack_binding.h"

#include "detached_shape.h"
#include "laid_layer.h"
#include "offset_error.h"
#include "offset_options_binding.h"
#include "offset_report_binding.h"
#include "python_progress.h"
#include "shape_exchange.h"
#include "without_gil.h"

#include <laminate_offset/ply_stack.h>

#include <array>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace laminate_offset::python
{
namespace
{

//! Thickness, which boundary, inset.
using PlyTuple = std::tuple<double, std::optional<std::size_t>, double>;
//! Name, shape, side, point.
using BoundaryTuple = std::tuple<std::string, py::object, std::string, std::array<double, 3>>;

PlySide side_by_name(const std::string &text)
{
    const std::pair<const char *, PlySide> sides[] = {{"inside", PlySide::Inside},
                                                      {"outside", PlySide::Outside},
                                                      {"left", PlySide::Left},
                                                      {"right", PlySide::Right},
                                                      {"nearest", PlySide::Nearest}};
    for (const auto &[name, side] : sides)
        if (text == name)
            return side;
    throw py::value_error("side must be inside, outside, left, right or nearest, not \"" + text + "\".");
}

RampSlope slope_by_name(const std::string &text)
{
    if (text == "mean")
        return RampSlope::Mean;
    if (text == "steepest")
        return RampSlope::Steepest;
    throw py::value_error("ramp_slope must be mean or steepest, not \"" + text + "\".");
}

py::object ramp_for_python(const std::optional<RampFigures> &ramp)
{
    using namespace py::literals;
    if (!ramp)
        return py::none();
    return py::dict("length"_a = ramp->length, "start_slope"_a = 0.0, "end_slope"_a = 0.0, "mean_slope"_a = ramp->mean,
                    "steepest_slope"_a = ramp->steepest);
}

py::list steep_ramps_for_python(const std::vector<SteepRamps> &places)
{
    using namespace py::literals;
    py::list result;
    for (const SteepRamps &steep : places)
        result.append(py::dict("slope"_a = steep.slope, "alone"_a = steep.alone,
                               "where"_a = place_for_python(steep.where), "longest"_a = steep.longest,
                               "plies"_a = steep.plies));
    return result;
}

std::vector<PlySpec> plies_of(const std::vector<PlyTuple> &tuples)
{
    std::vector<PlySpec> plies;
    for (const auto &[thickness, boundary, inset] : tuples)
        plies.push_back({thickness, boundary, inset});
    return plies;
}

std::vector<PlyBoundary> boundaries_of(const std::vector<BoundaryTuple> &tuples)
{
    std::vector<PlyBoundary> boundaries;
    for (const auto &[name, shape, side, point] : tuples)
        boundaries.push_back(
            {name, from_part(shape, selected_exchange()), side_by_name(side), gp_Pnt(point[0], point[1], point[2])});
    return boundaries;
}

//! Plies that cover the same part of the face get the same Part.Face.
class Regions
{
public:
    py::object for_python(const TopoDS_Face &region)
    {
        for (const auto &[known, part] : m_known)
            if (known.IsSame(region))
                return part;
        m_known.emplace_back(region, to_part(region, selected_exchange()));
        return m_known.back().second;
    }

private:
    std::vector<std::pair<TopoDS_Face, py::object>> m_known;
};

py::tuple surface_for_python(const PlySurface &surface)
{
    return py::make_tuple(to_part(surface.result.shape, selected_exchange()), to_python(surface.result.report),
                          surface.over_ramp);
}

Result<PlyStackResult> run_without_gil(const TopoDS_Shape &face, const std::vector<PlySpec> &plies,
                                       const std::vector<PlyBoundary> &boundaries, PlyStackOptions options,
                                       PythonProgress &progress)
{
    options.progress = [&progress](double fraction) { return progress.report(fraction); };
    return without_gil([&] { return stack_plies(face, plies, boundaries, options); });
}

py::tuple stack_plies_for_python(const py::object &shape, const std::vector<PlyTuple> &plies,
                                 const std::vector<BoundaryTuple> &boundaries, double tolerance,
                                 std::optional<int> max_degree, double direction, double start, double ratio,
                                 std::optional<double> ramp_length, const std::string &ramp_slope,
                                 std::optional<double> boundary_gap, bool middle, py::object callback)
{
    const OffsetOptions common =
        make_options(0.0, tolerance, std::string(name(Method::SameParameter)), 0.0, max_degree);
    PlyStackOptions options;
    options.tolerance = tolerance;
    options.max_degree = common.max_degree;
    options.direction = direction;
    options.start = start;
    options.ratio = ratio;
    options.ramp_length = ramp_length;
    options.ramp_slope = slope_by_name(ramp_slope);
    options.boundary_gap = boundary_gap;
    options.middle = middle;
    const TopoDS_Shape face = from_part(shape, selected_exchange());
    PythonProgress progress(std::move(callback));
    const Result<PlyStackResult> result =
        run_without_gil(detached(face), plies_of(plies), boundaries_of(boundaries), options, progress);
    progress.rethrow();
    if (!result)
        raise(result.failure(), common);
    py::list made;
    Regions regions;
    for (const StackedPly &ply : result.value().plies)
    {
        const py::object between = ply.middle ? py::object(surface_for_python(*ply.middle)) : py::object(py::none());
        made.append(py::make_tuple(regions.for_python(ply.region), surface_for_python(ply.bottom), between,
                                   surface_for_python(ply.top), LaidLayer{ply.distance, ply.thickness},
                                   ramp_for_python(ply.ramp)));
    }
    const std::optional<TopoDS_Face> &moved = result.value().moved_seam;
    const py::object lay_up = moved ? to_part(*moved, selected_exchange()) : py::object(py::none());
    return py::make_tuple(lay_up, made, result.value().boundary_gaps, result.value().inset_error,
                          steep_ramps_for_python(result.value().steep_ramps), result.value().elapsed);
}

} // namespace

void bind_ply_stack(py::module_ &module)
{
    const PlyStackOptions defaults;
    module.def(
        "stack_plies", &stack_plies_for_python, py::arg("shape"), py::arg("plies"), py::arg("boundaries"),
        py::arg("tolerance") = defaults.tolerance, py::arg("max_degree") = py::none(),
        py::arg("direction") = defaults.direction, py::arg("start") = defaults.start, py::arg("ratio") = defaults.ratio,
        py::arg("ramp_length") = py::none(), py::arg("ramp_slope") = "mean", py::arg("boundary_gap") = py::none(),
        py::arg("middle") = defaults.middle, py::arg("progress") = py::none(),
        "Lays plies that may cover parts of one Part.Face; lengths in mm. Returns the face with its seam moved, "
        "or None where that was not needed; for each ply its region and "
        "(shape, report, over a ramp) of its bottom, middle or None, and top, its LaidLayer and the figures of its "
        "ramp or None; for each boundary its "
        "largest distance from the face or None; the largest error seen of an inset; a list of where ramps that lie "
        "over "
        "each other are steeper than one alone; and the time in ms; or raises "
        "OffsetError, ValueError or TypeError.");
}

} // namespace laminate_offset::python
