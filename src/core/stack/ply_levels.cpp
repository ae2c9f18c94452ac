// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_levels.h"

#include "ply_ramp.h"
#include "ramp_slope.h"
#include "stack_surfaces.h"
#include "swept_form.h"

#include "../surface/check_meetings.h"
#include "../surface/variable_offset.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace laminate_offset
{
namespace
{

// A surface over ramps with more poles than that takes minutes and megabytes.
constexpr int most_poles = 40000;
// Of the surfaces' tolerance: what the family of constant distances may take from a fit over ramps.
constexpr double family_share = 0.4;
// A ramp is made longer so often, each time by what its slope says and a little more, or by this factor at least.
constexpr int most_lengths = 8;
constexpr double length_margin = 1.01;
constexpr double least_growth = 1.02;
// Ramps over each other are told of where together they are steeper than one alone by more than this factor. Each of them
// takes this part of the slope at least.
constexpr double most_alone = 1.05;
constexpr double acting_part = 0.02;

//! What one surface is made of.
struct Recipe
{
    std::vector<std::pair<std::size_t, double>> below; //!< plies and how much of each
    std::vector<std::size_t> regions;                  //!< where the surface is used
    double nominal = 0.0;
    double constant = 0.0; //!< the part of the distance that does not vary there
    //! Plies whose ramps it lies over, and how much of each [mm].
    std::vector<std::pair<std::size_t, double>> ramps;
    std::optional<ScalarSpline> varying; //!< constant and varying part together
};

struct Share
{
    ScalarSpline spline;
    PlyRamp ramp;
};

//! The refusal of an analysis; that of a crease says what a stack of plies with boundaries needs.
Failure with_remedy(const Failure &failure)
{
    if (failure.status != Status::KinkedSurface)
        return failure;
    return {
        Status::NotSupported, Stage::Analysis,
        "The face has a crease at the reported place, and plies with boundaries need a face without: split the face "
        "along the crease (in FreeCAD: Part > Split > Slice apart, with a plane or curve through the crease) and "
        "stack each of its parts.",
        failure.where, std::nullopt};
}

class LevelMaker
{
public:
    LevelMaker(const InputFace &input, const Stacking &stacking, const std::vector<PlyRegion> &regions,
               const OffsetOptions &options)
        : m_input(input), m_stacking(stacking), m_regions(regions), m_options(options)
    {
    }

    Result<PlyLevels> run()
    {
        list_recipes();
        std::vector<double> nominals;
        for (const Recipe &recipe : m_recipes)
            nominals.push_back(recipe.nominal);
        const StackDistances nominal(nominals);
        const double farthest = std::abs(nominal.low) > std::abs(nominal.high) ? nominal.low : nominal.high;
        Result<SurfaceAnalysis> analysis = analysed(farthest);
        if (!analysis)
            return analysis.failure();
        for (std::size_t k = 0; k < m_regions.size(); ++k)
            m_inside.push_back(fine_region(analysis.value().base, m_regions[k], shortest_ramp()));
        for (Recipe &recipe : m_recipes)
            if (const Result<bool> ok = resolve(recipe, analysis.value().base); !ok)
                return ok.failure();
        const bool varies = std::any_of(m_recipes.begin(), m_recipes.end(),
                                        [](const Recipe &recipe) { return recipe.varying.has_value(); });
        const Result<std::vector<OffsetSurface>> surfaces =
            varies ? with_ramps(analysis.value()) : all_constant(analysis.value());
        if (!surfaces)
            return surfaces.failure();
        std::vector<AddedRamps> added = added_ramps(analysis.value().base);
        PlyLevels levels{std::move(analysis).value(), {}, {}, m_inside, {}, std::move(added)};
        for (const LaidPly &ply : m_stacking.plies)
        {
            const auto known = m_shares.find({ply.region, ply.ramp});
            levels.ramps.push_back(known == m_shares.end() ? std::nullopt
                                                           : std::optional<PlyRamp>(known->second.value().ramp));
        }
        const std::size_t between = m_stacking.plies.size() + 1;
        for (std::size_t i = 0; i < m_recipes.size(); ++i)
            (i < between ? levels.between : levels.middle)
                .push_back({surfaces.value()[i], m_recipes[i].nominal, m_recipes[i].constant,
                            std::move(m_recipes[i].varying)});
        return levels;
    }

private:
    void list_recipes()
    {
        const std::vector<LaidPly> &plies = m_stacking.plies;
        Recipe below;
        below.nominal = m_stacking.start;
        std::vector<Recipe> middle;
        for (std::size_t j = 0; j <= plies.size(); ++j)
        {
            Recipe between = below;
            for (std::size_t ply = j == 0 ? 0 : j - 1; ply <= j && ply < plies.size(); ++ply)
                between.regions.push_back(plies[ply].region);
            m_recipes.push_back(std::move(between));
            if (j == plies.size())
                break;
            if (m_stacking.middle)
            {
                Recipe half = below;
                half.below.emplace_back(j, 0.5);
                half.nominal += 0.5 * plies[j].thickness;
                half.regions = {plies[j].region};
                middle.push_back(std::move(half));
            }
            below.below.emplace_back(j, 1.0);
            below.nominal += plies[j].thickness;
        }
        m_recipes.insert(m_recipes.end(), middle.begin(), middle.end());
    }

    //! Of the face's own surface, or of a swept one with the same parameters where only that has a model.
    Result<SurfaceAnalysis> analysed(double farthest) const
    {
        InputFace input = m_input;
        const bool partial = std::any_of(m_regions.begin(), m_regions.end(),
                                         [](const PlyRegion &region) { return !region.cuts.empty(); });
        if (partial)
            input.surface = swept_form(m_input.surface);
        Result<SurfaceAnalysis> analysis = analyse(input, farthest, m_options.tolerance);
        if (!analysis)
            return with_remedy(analysis.failure());
        return analysis;
    }

    [[nodiscard]] double shortest_ramp() const
    {
        double shortest = std::numeric_limits<double>::max();
        for (const LaidPly &ply : m_stacking.plies)
            shortest = std::min(shortest, ply.ramp);
        return shortest;
    }

    [[nodiscard]] bool whole(std::size_t region) const { return m_regions[region].cuts.empty(); }

    [[nodiscard]] RectangleFilter used(const Recipe &recipe) const
    {
        return [this, regions = recipe.regions](const ParameterBox &box) {
            return std::any_of(regions.begin(), regions.end(),
                               [&](std::size_t region) { return m_inside[region].may_touch(box); });
        };
    }

    //! Sums up the distance over the regions where the surface is used.
    Result<bool> resolve(Recipe &recipe, const BaseSurface &base)
    {
        recipe.constant = m_stacking.start;
        const RectangleFilter needed = used(recipe);
        for (const auto &[ply, part] : recipe.below)
        {
            const LaidPly &laid = m_stacking.plies[ply];
            const double thickness = part * laid.thickness;
            const bool on_itself = std::all_of(recipe.regions.begin(), recipe.regions.end(),
                                               [&](std::size_t region) { return region == laid.region; });
            if (whole(laid.region) || on_itself)
            {
                recipe.constant += thickness;
                continue;
            }
            const Result<Share> &found = share_of(laid, base);
            if (!found)
                return found.failure();
            const ScalarSpline &share = found.value().spline;
            const auto touched = [&](double u0, double u1, double v0, double v1) { return needed({u0, u1, v0, v1}); };
            if (const std::optional<double> same = share.constant_where(touched))
            {
                recipe.constant += *same * thickness;
                continue;
            }
            const ParameterBox &box = base.box();
            if (!recipe.varying)
                recipe.varying = ScalarSpline::constant(0.0, box.umin, box.umax, box.vmin, box.vmax);
            recipe.varying = sum(*recipe.varying, thickness, share);
            recipe.ramps.emplace_back(ply, thickness);
        }
        if (!recipe.varying)
            return true;
        for (double &pole : recipe.varying->poles)
            pole += recipe.constant;
        if (recipe.varying->poles.size() > most_poles)
            return Failure{Status::NotSupported, Stage::Surface,
                           fmt::format("The ramps of all plies together would take {} poles, more than {}; make ramps "
                                       "longer, or lead boundaries along parameter lines.",
                                       recipe.varying->poles.size(), most_poles),
                           std::nullopt, std::nullopt};
        return true;
    }

    const Result<Share> &share_of(const LaidPly &laid, const BaseSurface &base)
    {
        const auto key = std::make_pair(laid.region, laid.ramp);
        const auto known = m_shares.find(key);
        if (known != m_shares.end())
            return known->second;
        return m_shares.emplace(key, made_share(laid, base)).first->second;
    }

    //! Of every set of boundaries the worst place of all surfaces that lie over several ramps, the worst set first.
    [[nodiscard]] std::vector<AddedRamps> added_ramps(const BaseSurface &base) const
    {
        std::vector<const Recipe *> over_several;
        for (std::size_t i = 0; i <= m_stacking.plies.size(); ++i)
        {
            const Recipe &recipe = m_recipes[i];
            const bool known = !over_several.empty() && over_several.back()->ramps == recipe.ramps &&
                               over_several.back()->regions == recipe.regions;
            if (recipe.ramps.size() > 1 && !known)
                over_several.push_back(&recipe);
        }
        std::vector<RampsByBoundaries> found(over_several.size());
        tbb::parallel_for(std::size_t{0}, found.size(),
                          [&](std::size_t i) { found[i] = added(*over_several[i], base); });
        RampsByBoundaries worst;
        for (const RampsByBoundaries &one : found)
            for (const auto &[boundaries, place] : one)
                keep_worse(worst, boundaries, place);
        std::vector<AddedRamps> places;
        for (const auto &[boundaries, place] : worst)
            places.push_back(place);
        std::stable_sort(places.begin(), places.end(), [](const AddedRamps &a, const AddedRamps &b) {
            return a.slope * b.alone > b.slope * a.alone;
        });
        return places;
    }

    using RampsByBoundaries = std::map<std::set<std::string>, AddedRamps>;

    static void keep_worse(RampsByBoundaries &worst, const std::set<std::string> &boundaries, const AddedRamps &place)
    {
        const auto [known, is_new] = worst.emplace(boundaries, place);
        if (!is_new && place.slope * known->second.alone > known->second.slope * place.alone)
            known->second = place;
    }

    //! Where one surface is steep because several ramps lie over each other.
    [[nodiscard]] RampsByBoundaries added(const Recipe &recipe, const BaseSurface &base) const
    {
        std::vector<ActingRamp> ramps;
        double least = std::numeric_limits<double>::max();
        for (const auto &[ply, thickness] : recipe.ramps)
        {
            const LaidPly &laid = m_stacking.plies[ply];
            const Share &share = m_shares.at({laid.region, laid.ramp}).value();
            const double height = std::abs(thickness);
            const double alone = std::max(height * share.ramp.steepest, height / laid.ramp);
            ramps.push_back({ply, share.spline.as_surface(), height, alone, share.ramp.length});
            least = std::min(least, alone);
        }
        RampsByBoundaries worst;
        for (const std::size_t region : recipe.regions)
            for (const SteepPlace &place : steep_places(base, *recipe.varying, m_inside[region], most_alone * least))
            {
                const AddedRamps here = acting_at(place, ramps, base);
                if (here.plies.size() < 2 || !(here.slope > most_alone * here.alone))
                    continue;
                std::set<std::string> boundaries;
                for (const std::size_t ply : here.plies)
                    boundaries.insert(m_regions[m_stacking.plies[ply].region].name);
                keep_worse(worst, boundaries, here);
            }
        return worst;
    }

    struct ActingRamp
    {
        std::size_t ply;
        TensorSpline share;
        double height; //!< [mm]
        double alone;  //!< slope of it alone, or the one that was asked for
        double length; //!< [mm]
    };

    static AddedRamps acting_at(const SteepPlace &place, const std::vector<ActingRamp> &ramps, const BaseSurface &base)
    {
        AddedRamps added{place.slope, 0.0, place.uv, 0.0, {}};
        for (const ActingRamp &ramp : ramps)
            if (ramp.height * slope_at(base, ramp.share, place.uv) >= acting_part * place.slope)
            {
                added.plies.push_back(ramp.ply);
                added.alone = std::max(added.alone, ramp.alone);
                added.longest = std::max(added.longest, ramp.length);
            }
        return added;
    }

    //! Where the steepest slope is given, the ramp grows until it holds.
    Result<Share> made_share(const LaidPly &laid, const BaseSurface &base) const
    {
        const LoopRegion inside(m_input);
        double length = laid.ramp;
        for (int i = 0; i < most_lengths; ++i)
        {
            Result<ScalarSpline> share = ply_share(base, m_regions[laid.region], length, most_poles);
            if (!share)
                return share.failure();
            const double steepest = steepest_place(base, share.value(), inside).slope;
            if (!m_stacking.steepest || steepest * laid.ramp <= 1.0)
                return Share{std::move(share).value(), {length, steepest}};
            length *= std::max(least_growth, length_margin * steepest * laid.ramp);
        }
        return Failure{Status::NotSupported, Stage::Surface,
                       fmt::format("No ramp beside the boundary '{}' is nowhere steeper than asked for; give the mean "
                                   "slope of ramps instead, or smooth the boundary.",
                                   m_regions[laid.region].name),
                       std::nullopt, std::nullopt};
    }

    Result<std::vector<OffsetSurface>> all_constant(const SurfaceAnalysis &analysis) const
    {
        std::vector<double> distances;
        for (const Recipe &recipe : m_recipes)
            distances.push_back(recipe.constant);
        Result<StackSurfaces> made = stack_surfaces(analysis, m_input, StackDistances(distances), m_options);
        if (!made)
            return made.failure();
        return std::move(made.value().surfaces);
    }

    Result<std::vector<OffsetSurface>> with_ramps(const SurfaceAnalysis &analysis) const
    {
        std::vector<double> ends;
        for (const Recipe &recipe : m_recipes)
        {
            ends.push_back(recipe.varying ? recipe.varying->low() : recipe.constant);
            ends.push_back(recipe.varying ? recipe.varying->high() : recipe.constant);
        }
        const StackDistances range(ends);
        const double tolerance = surface_share * m_options.tolerance;
        for (const double end : {range.low, range.high})
            if (const Result<bool> feasible = check_distance(analysis, m_input, end); !feasible)
                return feasible.failure();
        const Result<OffsetFamily> family =
            fit_offset_family(analysis, m_input, range.low, range.high, family_share * tolerance, m_options);
        if (!family)
            return beside_a_tip(family.failure());
        bool apart = true;
        for (const double end : {range.low, range.high})
        {
            const Result<bool> settled =
                check_meetings(analysis, m_input, member(family.value(), end), end, m_options.tolerance, fewer_plies);
            if (!settled)
                return settled.failure();
            apart = apart && settled.value();
        }
        Result<std::vector<OffsetSurface>> surfaces = each(analysis, family.value(), tolerance);
        if (surfaces)
            for (OffsetSurface &surface : surfaces.value())
                surface.apart = apart;
        return surfaces;
    }

    //! A failure of the fit, with the reason for it where the face ends in a point.
    [[nodiscard]] Failure beside_a_tip(const Failure &failure) const
    {
        if (failure.status == Status::ToleranceNotReached || failure.status == Status::SingularNormal)
            for (const TrimmingLoop &loop : m_input.loops)
                for (const TrimmingCurve &curve : loop.curves)
                    if (curve.degenerated)
                        return {Status::NotSupported, Stage::Surface,
                                fmt::format("The face ends in a point, where its normal has no proven bound, and so "
                                            "surfaces over ramps have none up to it; cut the tip off the face, or lay "
                                            "the plies with boundaries on a part of the face without it. The fit "
                                            "said: {}",
                                            failure.message),
                                m_input.place(curve.pcurve->Value(0.5 * (curve.first + curve.last))), std::nullopt};
        return failure;
    }

    static OffsetSurface member(const OffsetFamily &family, double distance)
    {
        return {to_geom(family.at(distance)), {0.0, 0.0}, family.certified_error, family.sampled_error};
    }

    Result<std::vector<OffsetSurface>> each(const SurfaceAnalysis &analysis, const OffsetFamily &family,
                                            double tolerance) const
    {
        OffsetOptions options = m_options;
        options.progress = nullptr;
        std::vector<std::optional<Result<OffsetSurface>>> made(m_recipes.size());
        tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
            const Recipe &recipe = m_recipes[i];
            if (recipe.varying)
                made[i] = fit_variable_offset({m_input, family, *recipe.varying, tolerance, used(recipe), options});
            else if (std::optional<OffsetSurface> exact = exact_offset(m_input, recipe.constant, m_options.tolerance))
                made[i] = *std::move(exact);
            else if (recipe.constant == 0.0)
                made[i] = offset_surface(analysis, m_input, 0.0, options);
            else
                made[i] = member(family, recipe.constant);
        });
        std::vector<OffsetSurface> surfaces;
        for (std::optional<Result<OffsetSurface>> &one : made)
        {
            if (!one->ok())
                return one->failure();
            surfaces.push_back(std::move(*one).value());
        }
        return surfaces;
    }

    const InputFace &m_input;
    const Stacking &m_stacking;
    const std::vector<PlyRegion> &m_regions;
    const OffsetOptions &m_options;
    std::vector<LoopRegion> m_inside; //!< of each region
    std::vector<Recipe> m_recipes;    //!< the surfaces between plies, then those in their middle
    std::map<std::pair<std::size_t, double>, Result<Share>> m_shares;
};

} // namespace

const PlyLevel &PlyLevels::of(std::size_t ply, std::size_t which, bool with_middle) const
{
    if (with_middle && which == 1)
        return middle[ply];
    return between[ply + (which == 0 ? 0 : 1)];
}

Result<bool> check_uncreased(const InputFace &input, double farthest, double tolerance)
{
    if (const Result<SurfaceAnalysis> base = read_base(input, farthest, tolerance); !base)
        return with_remedy(base.failure());
    return true;
}

Result<PlyLevels> ply_levels(const InputFace &input, const Stacking &stacking, const std::vector<PlyRegion> &regions,
                             const OffsetOptions &options)
{
    return LevelMaker(input, stacking, regions, options).run();
}

} // namespace laminate_offset
