// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! One part in a search for meetings with others: its surfaces, and what is known of their patches.
#pragma once

#include "parameter_periods.h"
#include "patch_tree.h"
#include "surface_analysis.h"

#include "../spline/tensor_spline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace laminate_offset
{

//! The range of a linear form over a box.
struct Reach
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    static Reach of(const Eigen::Vector3d &axis, const Eigen::AlignedBox3d &box)
    {
        const double middle = axis.dot(box.center());
        const double half = 0.5 * axis.cwiseAbs().dot(box.sizes());
        return {middle - half, middle + half};
    }
    void extend(const Reach &other)
    {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    [[nodiscard]] double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

//! One part with its offset, in the base's parameters over the base's box.
struct MeetingPart
{
    const InputFace &input;
    const SurfaceAnalysis &analysis;
    TensorSpline far;
    std::optional<TensorSpline> near; //!< where the slab between the two counts
};

//! The shifts of a parameter to look at: none, and the period both ways where it has one.
std::vector<double> period_shifts(double period);

//! A surface of one part.
struct Sheet
{
    Sheet(const TensorSpline &own, const Eigen::Vector3d &from) : spline(&own), tree(own, from), origin(from) {}

    [[nodiscard]] Eigen::Vector3d at(double u, double v) const { return spline->jets({u}, {v}, 0).front().s - origin; }

    const TensorSpline *spline;
    PatchTree tree;
    Eigen::Vector3d origin;
};

//! A surface over a patch: its middle point and bounds.
struct SheetBounds
{
    Eigen::Vector3d middle;
    PatchBounds bounds;

    [[nodiscard]] Reach along(const Eigen::Vector3d &axis, const ParameterBox &box) const;
};

//! One part: its surfaces and their patches, which are numbered as in the search's tree. That one is a tree of the
//! far surface of its own: bounds over narrow rectangles halve theirs into narrow patches.
class MeetingBody
{
public:
    //! \param part with a base that is a spline or has a model; it must outlive the body.
    //! \param tolerance that decides where the base is closed [mm].
    MeetingBody(const MeetingPart &part, double tolerance, const Eigen::Vector3d &origin);

    [[nodiscard]] const MeetingPart &part() const { return m_part; }
    [[nodiscard]] const Periods &periods() const { return m_periods; }
    [[nodiscard]] PatchTree &tree() { return m_tree; }
    [[nodiscard]] bool is_slab() const { return m_sheets.size() > 1; }
    [[nodiscard]] const ParameterBox &box(int index) { return tree().node(index).box; }

    //! Of every surface.
    const std::vector<SheetBounds> &patch(int index);

    //! Is any part of the patch inside the loops?
    bool touches(int index);

    //! Bounds of every surface over a rectangle, whose parameters may go on across a seam.
    std::vector<PatchBounds> over(const ParameterBox &box);

    PatchBounds base_over(const ParameterBox &box) { return wrapped(m_base.tree, box); }

    //! The points of all surfaces at one place, whose parameters may go on across a seam.
    [[nodiscard]] std::vector<Eigen::Vector3d> points(double u, double v) const;

    //! Point and derivatives at a height, the last one with respect to the height.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> jet(double u, double v, double height) const;

    //! The same at a part of the far surface's distance, with respect to which the last one is.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> jet_at(double u, double v, double part) const;

    //! The same where the part does not change.
    [[nodiscard]] std::array<Eigen::Vector3d, 4> still_at(double u, double v, double part) const;

    [[nodiscard]] SurfaceJet base(double u, double v) const { return m_part.analysis.base.jets({u}, {v}, 1).front(); }

private:
    [[nodiscard]] PatchBounds wrapped(PatchTree &tree, const ParameterBox &box) const;

    const MeetingPart &m_part;
    Periods m_periods;
    Sheet m_base;
    PatchTree m_tree;
    std::vector<std::unique_ptr<Sheet>> m_sheets; //!< the far one first
    std::vector<std::vector<SheetBounds>> m_patches;
    std::vector<signed char> m_touches;
};

} // namespace laminate_offset
