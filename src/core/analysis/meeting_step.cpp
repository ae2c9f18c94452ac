// SPDX-License-Identifier: LGPL-2.1-or-later
#include "meeting_step.h"

#include <Eigen/QR>

#include <algorithm>

namespace laminate_offset
{

void step_together(const SurfaceJet &a, const SurfaceJet &b, const ParameterBox &box, Eigen::Vector4d &place)
{
    const double width = box.umax - box.umin;
    const double height = box.vmax - box.vmin;
    const Eigen::Vector4d scale(width, height, width, height);
    const Eigen::Vector3d residual = a.s - b.s;
    Eigen::Matrix<double, 3, 4> jacobian;
    jacobian << a.u, a.v, -b.u, -b.v;
    jacobian *= scale.asDiagonal();
    const Eigen::Vector4d move = jacobian.completeOrthogonalDecomposition().solve(residual);
    place -= scale.cwiseProduct(move);
    for (const int k : {0, 2})
    {
        place[k] = std::clamp(place[k], box.umin, box.umax);
        place[k + 1] = std::clamp(place[k + 1], box.vmin, box.vmax);
    }
}

} // namespace laminate_offset
