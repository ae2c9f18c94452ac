// SPDX-License-Identifier: LGPL-2.1-or-later
#include "extension_report.h"

#include <nlohmann/json.hpp>

namespace laminate_offset
{

ExtensionReport extension_report(const ExtendedSurface &surface, const ExtensionOptions &options)
{
    ExtensionReport report;
    report.message = "The extension was made.";
    report.length = options.length;
    report.continuity = options.continuity;
    report.rule = options.rule;
    report.sides = surface.sides;
    report.surface = summary_of(surface.geometry);
    return report;
}

ExtensionReport refusal_report(const Failure &failure, const ExtensionOptions &options)
{
    ExtensionReport report;
    report.status = failure.status;
    report.stage = failure.stage;
    report.message = failure.message;
    report.where = failure.where;
    report.length = options.length;
    report.continuity = options.continuity;
    report.rule = options.rule;
    return report;
}

nlohmann::ordered_json to_json(const ExtensionReport &report)
{
    return {{"status", name(report.status)},  {"stage", name(report.stage)},    {"message", report.message},
            {"where", to_json(report.where)}, {"length", report.length},        {"continuity", name(report.continuity)},
            {"rule", name(report.rule)},      {"sides", to_json(report.sides)}, {"surface", to_json(report.surface)},
            {"elapsed_ms", report.elapsed_ms}};
}

} // namespace laminate_offset
