// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! ExtensionReport: what was done to the sides of one face, with measured figures.
#pragma once

#include "../base/extension_options.h"
#include "../base/result.h"
#include "../extension/extend_surface.h"
#include "offset_report.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace laminate_offset
{

struct ExtensionReport
{
    Status status = Status::Ok;
    Stage stage = Stage::Report; //!< the last stage that ran, or the one that refused
    std::string message;
    std::optional<Where> where;

    double length = 0.0; //!< as asked [mm]
    Continuity continuity = Continuity::G1;
    LengthRule rule = LengthRule::Mean;
    std::vector<ExtendedSide> sides;       //!< in the order in which they were extended; empty when refused
    std::optional<SurfaceSummary> surface; //!< empty when refused
    double elapsed_ms = 0.0;               //!< wall-clock time
};

ExtensionReport extension_report(const ExtendedSurface &surface, const ExtensionOptions &options);

//! Report of a refusal.
ExtensionReport refusal_report(const Failure &failure, const ExtensionOptions &options);

//! {"status", "stage", "message", "where", "length", "continuity", "rule", "sides", "surface", "elapsed_ms"}; sides as in
//! the report of an offset.
nlohmann::ordered_json to_json(const ExtensionReport &report);

} // namespace laminate_offset
