// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_surface.h"

#include "one_space_fit.h"

namespace laminate_offset
{

Result<OffsetSurface> fit_offset(const SurfaceAnalysis &analysis, const InputFace &input, double distance,
                                 double tolerance, const OffsetOptions &options)
{
    const Result<OneSpaceFit> fitted = fit_in_one_space({analysis, input, {distance}, tolerance, options, {}});
    if (!fitted)
        return fitted.failure();
    const OneSpaceFit &fit = fitted.value();
    return OffsetSurface{to_geom(fit.splines.front()), {0.0, 0.0}, fit.certified_error, fit.sampled_error};
}

} // namespace laminate_offset
