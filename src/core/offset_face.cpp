// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_face.h"

#include "analysis/creases.h"
#include "analysis/surface_analysis.h"
#include "extension/extended_offset.h"
#include "input/input_face.h"
#include "projection/edge_images.h"
#include "report/face_report.h"
#include "surface/check_meetings.h"
#include "surface/cut_offset.h"
#include "surface/offset_surface.h"
#include "topology/build_face.h"
#include "topology/extended_face.h"
#include "trimming/check_edges.h"
#include "trimming/tear.h"
#include "trimming/trim_loops.h"

#include <TopoDS.hxx>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace laminate_offset
{
namespace
{

// A seam is one edge for both of its sides: what tears it, by less than a crease, may still be more than the edge has left.
// Then it counts as a crease from this part of a crease's tear on.
constexpr double seam_share = 0.1;

//! Runs the stages one after the other, times them, and turns OpenCASCADE's exceptions into refusals.
class Pipeline
{
public:
    Pipeline(const OffsetOptions &options, std::string_view remedy) : m_options(options), m_meeting_remedy(remedy) {}

    Result<OffsetResult> run(const TopoDS_Shape &shape)
    {
        try
        {
            return run_stages(shape);
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, m_stage);
        }
    }

private:
    using Clock = std::chrono::steady_clock;

    //! A face after the stages that make its offset surface.
    struct Surfaced
    {
        SurfaceAnalysis analysis;
        OffsetSurface surface;
    };

    //! A face, or a part of it, after the stages that make its offset.
    struct Made
    {
        SurfaceAnalysis analysis;
        OffsetSurface surface;
        TrimLoops loops;
        TopoDS_Face face;
        OffsetReport report;
    };

    void enter(Stage stage)
    {
        leave();
        m_stage = stage;
        m_entered = Clock::now();
    }

    void leave()
    {
        if (m_entered == Clock::time_point{})
            return;
        const std::chrono::duration<double, std::milli> spent = Clock::now() - m_entered;
        add_time(m_stage, spent.count());
        m_entered = {};
    }

    void add_time(Stage of, double spent)
    {
        auto stage = std::find_if(m_elapsed.stages.begin(), m_elapsed.stages.end(),
                                  [&](const auto &known) { return known.first == of; });
        if (stage == m_elapsed.stages.end())
            stage = m_elapsed.stages.insert(stage, {of, 0.0});
        stage->second += spent;
        m_elapsed.total += spent;
    }

    Result<OffsetResult> run_stages(const TopoDS_Shape &shape)
    {
        if (const Result<bool> checked = check(m_options); !checked)
            return checked.failure();
        enter(Stage::Input);
        const Result<InputFace> input = read_face(shape);
        if (!input)
            return input.failure();
        Result<Surfaced> surface = surfaced(input.value(), m_options);
        if (!surface && surface.failure().status == Status::KinkedSurface)
        {
            const Result<std::vector<InputFace>> parts = parts_of(input.value(), m_options.tolerance);
            return parts ? run_parts(input.value(), parts.value()) : parts.failure();
        }
        if (!surface)
            return surface.failure();
        Result<Made> whole = trimmed(input.value(), surface.value(), m_options);
        if (!whole && whole.failure().status == Status::EdgeToleranceNotReached)
            if (const auto parts = parts_of(input.value(), seam_share * m_options.tolerance);
                parts && parts.value().size() > 1)
                return run_open(input.value(), parts.value(), surface.value());
        if (whole && m_options.extension > 0.0 && m_options.method == Method::SameParameter)
            whole = extended(input.value(), std::move(whole).value());
        leave();
        if (!whole)
            return whole.failure();
        OffsetReport report = std::move(whole.value().report);
        report.elapsed = m_elapsed;
        return OffsetResult{whole.value().face, std::move(report)};
    }

    //! The offset face extended past its sides. A refusal names the place of the base.
    Result<Made> extended(const InputFace &base, Made made)
    {
        enter(Stage::Extension);
        const gp_Vec2d back = -made.surface.parameter_shift;
        const auto on_base = [&](Failure failure) {
            if (failure.where)
                failure.where = base.place(failure.where->uv.Translated(back));
            return failure;
        };
        const Result<InputFace> offset = read_face(made.face);
        if (!offset)
            return offset.failure();
        ExtensionOptions options;
        options.length = m_options.extension;
        Result<ExtendedSurface> surface = extend_surface({offset.value(), offset.value().surface}, options);
        if (!surface)
            return on_base(surface.failure());
        enter(Stage::Topology);
        const Result<TopoDS_Face> face = build_extended_face(offset.value(), surface.value());
        if (!face)
            return on_base(face.failure());
        made.face = face.value();
        made.report.surface = summary_of(surface.value().geometry);
        made.report.extension = Extension{m_options.extension, surface.value().sides};
        return made;
    }

    //! \param tolerance half of it is how far a crease may tear the offset [mm].
    Result<std::vector<InputFace>> parts_of(const InputFace &input, double tolerance)
    {
        enter(Stage::Analysis);
        if (m_options.extension > 0.0)
            return Failure{Status::NotSupported, Stage::Extension,
                           "The face has creases that tear its offset into parts, which cannot be extended together; "
                           "offset without an extension, or extend the base face first.",
                           input.place(input.loops.front().curves.front().pieces.front().start), std::nullopt};
        return split_at_creases(input, input.from_surface(m_options.distance), tolerance);
    }

    //! The parts between creases, each through all stages on its own.
    Result<OffsetResult> run_parts(const InputFace &input, const std::vector<InputFace> &parts)
    {
        std::vector<std::optional<Result<Made>>> tried(parts.size());
        if (!m_options.progress) // which is told by one thread
            make_at_once(parts, tried);
        std::vector<Made> made;
        for (std::size_t i = 0; i < parts.size(); ++i)
        {
            Result<Made> one = tried[i] ? *std::move(tried[i]) : make(parts[i], part_options(i, parts.size()));
            if (!one)
                return with_limits_of_all(one.failure(), input);
            made.push_back(std::move(one).value());
        }
        const Result<Creases> creases = examine_creases(parts, made);
        if (!creases)
            return creases.failure();
        return joined(input, parts, made, creases.value());
    }

    //! A face whose seam is torn by more than one edge can follow: its parts lie on the surface of the whole, whose ends are
    //! free to part at the seam, and have its limits.
    Result<OffsetResult> run_open(const InputFace &input, const std::vector<InputFace> &parts, const Surfaced &whole)
    {
        std::vector<Made> made;
        for (const InputFace &part : parts)
        {
            Surfaced own{{whole.analysis.base, LoopRegion(part), whole.analysis.negative, whole.analysis.positive,
                          whole.analysis.sampled},
                         cut_to(part, whole.surface, m_options.distance)};
            Result<Made> one = trimmed(part, own, m_options);
            if (!one)
                return one.failure();
            made.push_back(std::move(one).value());
        }
        return joined(input, parts, made,
                      {kind_of(edges_between(parts, made, seam_share * m_options.tolerance)), true});
    }

    //! What the parts of a creased face do to each other.
    struct Creases
    {
        std::optional<CreaseKind> kind;
        bool apart = true; //!< false: whether parts meet elsewhere could not be settled
    };

    OffsetResult joined(const InputFace &input, const std::vector<InputFace> &parts, const std::vector<Made> &made,
                        const Creases &creases)
    {
        enter(Stage::Topology);
        std::vector<OffsetPart> torn;
        std::vector<TopoDS_Face> faces;
        for (const Made &part : made)
        {
            torn.push_back({part.surface, part.loops});
            faces.push_back(part.face);
        }
        OffsetReport report = joint_report(input, parts, made);
        report.gap = tear_width(torn, m_options.tolerance);
        report.crease = creases.kind;
        report.apart = report.apart && creases.apart;
        leave();
        report.elapsed = m_elapsed;
        return OffsetResult{build_shell(input, faces), std::move(report)};
    }

    //! Each part by a pipeline of its own. Their stages share the time that passes.
    void make_at_once(const std::vector<InputFace> &parts, std::vector<std::optional<Result<Made>>> &made)
    {
        leave();
        const auto began = Clock::now();
        std::vector<Pipeline> pipelines(parts.size(), Pipeline(m_options, m_meeting_remedy));
        tbb::parallel_for(std::size_t{0}, parts.size(),
                          [&](std::size_t i) { made[i] = pipelines[i].make_alone(parts[i]); });
        const std::chrono::duration<double, std::milli> passed = Clock::now() - began;
        double sum = 0.0;
        for (const Pipeline &pipeline : pipelines)
            sum += pipeline.m_elapsed.total;
        for (const Pipeline &pipeline : pipelines)
            for (const auto &[stage, spent] : pipeline.m_elapsed.stages)
                add_time(stage, spent * passed.count() / sum);
    }

    Result<Made> make_alone(const InputFace &part)
    {
        try
        {
            Result<Made> made = make(part, m_options);
            leave();
            return made;
        }
        catch (const Standard_Failure &error)
        {
            return kernel_failure(error, m_stage);
        }
    }

    //! Whether the parts keep apart away from their creases, and what they do there.
    Result<Creases> examine_creases(const std::vector<InputFace> &parts, const std::vector<Made> &made)
    {
        enter(Stage::Surface);
        std::vector<AnalysedPart> analysed;
        for (std::size_t i = 0; i < made.size(); ++i)
        {
            const bool moved = made[i].surface.parameter_map || made[i].surface.parameter_shift.Magnitude() > 0.0;
            analysed.push_back({parts[i], made[i].analysis, moved ? nullptr : made[i].surface.geometry});
        }
        const std::vector<CreaseEdge> edges = edges_between(parts, made, m_options.tolerance);
        const Result<PartsApart> apart =
            check_part_meetings(analysed, edges, parts.front().from_surface(m_options.distance), m_options.tolerance,
                                Between::Nothing, m_meeting_remedy);
        if (!apart)
            return apart.failure();
        return Creases{kind_of(edges), apart.value().settled};
    }

    //! \param tolerance parts that tear by less than half of it neither open nor cross [mm].
    std::vector<CreaseEdge> edges_between(const std::vector<InputFace> &parts, const std::vector<Made> &made,
                                          double tolerance)
    {
        enter(Stage::Surface);
        std::vector<CreasedPart> creased;
        for (std::size_t i = 0; i < made.size(); ++i)
            creased.push_back({parts[i], made[i].analysis.base});
        return crease_edges(creased, parts.front().from_surface(m_options.distance), tolerance);
    }

    //! What would work for one part has to work for the others too.
    Failure with_limits_of_all(Failure failure, const InputFace &input) const
    {
        if (!failure.feasible_range)
            return failure;
        const double distance = input.from_surface(m_options.distance);
        if (Result<SurfaceAnalysis> analysis = read_creased_base(input, distance, m_options.tolerance))
        {
            find_limits(analysis.value(), input, 0.0, refusal_gap);
            failure.feasible_range = tightest(*failure.feasible_range, feasible_range(analysis.value(), input));
        }
        return failure;
    }

    //! The options for one of several parts, which reports its share of the progress.
    [[nodiscard]] OffsetOptions part_options(std::size_t index, std::size_t count) const
    {
        OffsetOptions options = m_options;
        if (m_options.progress)
            options.progress = [outer = m_options.progress, index, count](double fraction) {
                return outer((static_cast<double>(index) + fraction) / static_cast<double>(count));
            };
        return options;
    }

    Result<Made> make(const InputFace &input, const OffsetOptions &options)
    {
        Result<Surfaced> surface = surfaced(input, options);
        return surface ? trimmed(input, surface.value(), options) : surface.failure();
    }

    Result<Surfaced> surfaced(const InputFace &input, const OffsetOptions &options)
    {
        const double distance = input.from_surface(options.distance);
        enter(Stage::Analysis);
        Result<SurfaceAnalysis> analysis = analyse(input, distance, options.tolerance);
        if (!analysis)
            return analysis.failure();
        enter(Stage::Surface);
        Result<OffsetSurface> surface = checked_surface(input, analysis.value(), distance, options);
        if (!surface)
            return surface.failure();
        return Surfaced{std::move(analysis).value(), std::move(surface).value()};
    }

    //! \param of moved into the result; a refusal leaves it.
    Result<Made> trimmed(const InputFace &input, Surfaced &of, const OffsetOptions &options)
    {
        const double distance = input.from_surface(options.distance);
        Result<Surroundings> around = surroundings(input, of.surface, distance, options);
        if (!around)
            return around.failure();
        enter(Stage::Trimming);
        Result<TrimLoops> loops = offset_loops({input, of.analysis.base, of.surface, distance,
                                                edge_share * options.tolerance, nullptr, around.value().image()});
        if (!loops)
            return loops.failure();
        if (const Result<bool> close = check_edges(input, of.surface, loops.value(), options.tolerance); !close)
            return close.failure();
        enter(Stage::Topology);
        const Result<TopoDS_Face> face = build_face(input, of.surface, loops.value());
        if (!face)
            return face.failure();
        OffsetReport own = face_report(input, of.analysis, of.surface, loops.value(), options);
        own.extension = around.value().extension;
        return Made{std::move(of.analysis), std::move(of.surface), std::move(loops).value(), face.value(),
                    std::move(own)};
    }

    //! What the paper's route adds around the offset surface before it is trimmed: the extension, and what puts curves
    //! onto it.
    struct Surroundings
    {
        std::optional<Extension> extension;
        std::shared_ptr<const EdgeImages> images;

        [[nodiscard]] CurveImage image() const
        {
            if (!images)
                return {};
            return [on = images](const Handle(Geom_Curve) & curve, double first, double last, double accuracy) {
                return on->image({curve, first, last}, accuracy);
            };
        }
    };

    //! Extends the surface itself where the paper's route is asked for an extension.
    Result<Surroundings> surroundings(const InputFace &input, OffsetSurface &surface, double distance,
                                      const OffsetOptions &options)
    {
        Surroundings around;
        if (options.method != Method::RaviKumar || !(options.extension > 0.0))
            return around;
        enter(Stage::Extension);
        Result<ExtendedOffset> extended = extend_offset(input, surface, distance, options.extension);
        if (!extended)
            return extended.failure();
        surface = std::move(extended.value().surface);
        around.extension = Extension{options.extension, std::move(extended.value().sides)};
        if (!surface.parameter_map)
            return around; // the result keeps the base's parameters, and with them its pcurves
        std::optional<EdgeImages> images = EdgeImages::make(surface.geometry, extended.value().box, input.diagonal);
        if (images)
            around.images = std::make_shared<const EdgeImages>(std::move(*images));
        return around;
    }

    Result<OffsetSurface> checked_surface(const InputFace &input, const SurfaceAnalysis &analysis, double distance,
                                          const OffsetOptions &options)
    {
        if (const Result<bool> feasible = check_distance(analysis, input, distance); !feasible)
            return feasible.failure();
        Result<OffsetSurface> made = offset_surface(analysis, input, distance, options);
        if (!made)
            return made;
        const Result<bool> apart =
            check_meetings(analysis, input, made.value(), distance, options.tolerance, m_meeting_remedy);
        if (!apart)
            return apart.failure();
        made.value().apart = apart.value();
        return made;
    }

    //! Errors are the largest over the parts, limits the tightest; the surface is that of the largest part.
    static OffsetReport joint_report(const InputFace &input, const std::vector<InputFace> &parts,
                                     const std::vector<Made> &made)
    {
        const auto largest = std::max_element(
            parts.begin(), parts.end(), [](const InputFace &a, const InputFace &b) { return a.diagonal < b.diagonal; });
        OffsetReport joint = made[static_cast<std::size_t>(largest - parts.begin())].report;
        for (const Made &part : made)
            add_worse(part.report, joint);
        joint.loops = static_cast<int>(input.loops.size());
        joint.edges = input.edge_count();
        joint.faces = static_cast<int>(made.size());
        return joint;
    }

    static void add_worse(const OffsetReport &part, OffsetReport &joint)
    {
        for (const auto figure : {&OffsetReport::certified_error, &OffsetReport::sampled_error,
                                  &OffsetReport::edge_error, &OffsetReport::sampled_edge_error})
        {
            std::optional<double> &worst = joint.*figure;
            const std::optional<double> &own = part.*figure;
            worst = worst && own ? std::optional<double>(std::max(*worst, *own)) : std::nullopt;
        }
        if (part.limits && joint.limits)
            joint.limits = tightest(*part.limits, *joint.limits);
        joint.limits_proven = joint.limits_proven && part.limits_proven;
        joint.apart = joint.apart && part.apart;
    }

    const OffsetOptions &m_options;
    std::string_view m_meeting_remedy;
    Stage m_stage = Stage::Options;
    Clock::time_point m_entered;
    Elapsed m_elapsed;
};

} // namespace

TopoDS_Face OffsetResult::face() const { return TopoDS::Face(shape); }

Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options)
{
    return offset_face(shape, options, smaller_distance);
}

Result<OffsetResult> offset_face(const TopoDS_Shape &shape, const OffsetOptions &options,
                                 std::string_view meeting_remedy)
{
    return Pipeline(options, meeting_remedy).run(shape);
}

} // namespace laminate_offset
