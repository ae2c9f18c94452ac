// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! OffsetReport: what was done to one face, with measured and proven figures.
#pragma once

#include "../base/crease_kind.h"
#include "../base/options.h"
#include "../base/result.h"
#include "../extension/extend_surface.h"

#include <Geom_Surface.hxx>
#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace laminate_offset
{

//! The result's underlying surface; of several parts the one of the largest.
struct SurfaceSummary
{
    //! "plane", "cylinder", "cone", "sphere", "torus" or "bspline"; the copy of a base at distance 0 may also be a
    //! "revolution" or an "extrusion".
    std::string type;
    int degree_u = 0; //!< 0 for analytic surfaces, as are the pole counts
    int degree_v = 0;
    int poles_u = 0;
    int poles_v = 0;
    bool rational = false;
};

//! The summary of a surface.
SurfaceSummary summary_of(const Handle(Geom_Surface) & surface);

//! How the result was extended past its sides.
struct Extension
{
    double length = 0.0;             //!< as asked [mm]
    std::vector<ExtendedSide> sides; //!< in the order in which they were extended
};

//! Wall-clock time of the stages [ms], in the order they ran.
struct Elapsed
{
    double total = 0.0;
    std::vector<std::pair<Stage, double>> stages;
};

//! One face's report. Of a creased face's parts, errors are the largest (empty if one of them is) and limits the
//! tightest. to_json gives the documented format.
struct OffsetReport
{
    Status status = Status::Ok;
    Stage stage = Stage::Report; //!< the last stage that ran, or the one that refused
    std::string message;
    std::optional<Where> where;

    Method method = Method::SameParameter;
    double distance = 0.0;                    //!< as asked [mm]
    double tolerance = 0.0;                   //!< as asked [mm]
    std::optional<double> certified_error;    //!< proven bound of the surface deviation [mm]; never a sampled figure
    std::optional<double> sampled_error;      //!< largest deviation seen on a dense grid [mm]; for information
    std::optional<double> edge_error;         //!< proven bound of the edge curves' deviation [mm]
    std::optional<double> sampled_edge_error; //!< largest edge deviation seen [mm]; for information

    std::optional<SurfaceSummary> surface; //!< empty when refused
    //! Empty when not computed. Of a result they may fall short of the true limits by a tenth, where these are
    //! costly by a quarter or more; offset_limits() gives sharp ones.
    std::optional<FeasibleRange> limits;
    bool limits_proven =
        true;          //!< false: curvature could only be sampled somewhere (a pole, a base without spline or model)
    bool apart = true; //!< false: whether distant parts of the offset meet could not be settled within the budget
    std::optional<Extension> extension; //!< empty when none was asked for
    int loops = 0;                      //!< of the base face
    int edges = 0;                      //!< of the base face

    int faces = 0;                    //!< of the result; more than one where a crease tears the base into parts
    std::optional<double> gap;        //!< proven bound of the distance between two parts' edges along a crease [mm]
    std::optional<CreaseKind> crease; //!< what the parts leave there; empty for a single face
    Elapsed elapsed;
};

//! Report of a refusal: the options' figures and the failure's reason.
OffsetReport refusal_report(const Failure &failure, const OffsetOptions &options);

//! A place as {u,v,x,y,z}, or null.
nlohmann::ordered_json to_json(const std::optional<Where> &where);

//! A surface's summary as an object, or null.
nlohmann::ordered_json to_json(const std::optional<SurfaceSummary> &surface);

//! Extended sides as a list of {"side", "parameter", "mean_length", "shortest", "longest", "join_angle",
//! "moved_edges"}; lengths in mm, the angle in radians.
nlohmann::ordered_json to_json(const std::vector<ExtendedSide> &sides);

//! The report as a JSON object (keys in documentation order).
nlohmann::ordered_json to_json(const OffsetReport &report);

//! The report as indented JSON text, ending without a newline.
std::string to_json_text(const OffsetReport &report);

//! A few lines for a person.
std::string to_text(const OffsetReport &report);

} // namespace laminate_offset
