// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! An offset in one call, and its outcome in words.
#pragma once

#include <laminate_offset/offset_face.h>

#include <string>

namespace test_support
{

inline laminate_offset::Result<laminate_offset::OffsetResult> offset(const TopoDS_Face &face, double distance,
                                                                     double tolerance = 1e-3, int max_degree = 7)
{
    laminate_offset::OffsetOptions options;
    options.distance = distance;
    options.tolerance = tolerance;
    options.max_degree = max_degree;
    return laminate_offset::offset_face(face, options);
}

inline std::string why(const laminate_offset::Result<laminate_offset::OffsetResult> &result)
{
    if (result.ok())
        return "ok";
    const laminate_offset::Failure &failure = result.failure();
    return std::string(name(failure.status)) + " at " + std::string(name(failure.stage)) + ": " + failure.message;
}

} // namespace test_support
