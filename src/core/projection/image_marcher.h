// SPDX-License-Identifier: LGPL-2.1-or-later
//! \file
//! Along a space curve: nearest points of a surface, their parameters without jumps, seams and borders crossed.
#pragma once

#include "curve_image.h"

namespace laminate_offset
{

//! The nearest point at one parameter of the curve.
struct ImageFoot
{
    double t = 0.0;
    Eigen::Vector2d uv{0.0, 0.0};
    Eigen::Vector2d slope{0.0, 0.0}; //!< d(u, v)/dt: the curve's tangent dropped onto the parameters
    Eigen::Vector3d point{0.0, 0.0, 0.0};
    double distance = 0.0;  //!< to the curve [mm]
    bool outside = false;   //!< the foot is held back by the end of the surface
    bool on_border = false; //!< it lies on an end of the surface that is no seam
};

//! A part of the curve between seams and borders.
struct ImageRun
{
    std::vector<ImageFoot> feet;
    std::vector<double> corners; //!< parameters where the curve is less than C1
};

class ImageMarcher
{
public:
    ImageMarcher(const ImageSurface &on, const SpaceCurve &curve, double tolerance);

    [[nodiscard]] Eigen::Vector3d given(double t) const;

    //! \param hint parameters nearby, which settle the side of a seam and the free parameter at a pole.
    [[nodiscard]] ImageFoot foot(double t, const Eigen::Vector2d &hint) const;

    //! \param clip parts that lie outside are left out.
    [[nodiscard]] std::vector<ImageRun> runs(bool clip) const;

    //! Largest speed of the surface seen, in either parameter.
    [[nodiscard]] double speed() const { return m_speed; }

private:
    [[nodiscard]] std::vector<double> parameters() const;
    [[nodiscard]] std::vector<ImageFoot> feet() const;
    [[nodiscard]] bool jumps(const ImageFoot &a, const ImageFoot &b) const;
    void settle(ImageFoot &foot, const Eigen::Vector2d &hint) const;
    [[nodiscard]] bool on_seam(const ImageFoot &foot, int direction) const;
    [[nodiscard]] bool at_pole(const ImageFoot &foot, int direction) const;
    //! Where the curve reaches the border of the surface between a foot inside and the last one before it counts as
    //! outside.
    [[nodiscard]] ImageFoot border_crossing(const ImageFoot &inner, const ImageFoot &last) const;
    //! Both sides of the place between a and b where `differ` begins to hold.
    template <typename Differ>
    [[nodiscard]] std::pair<ImageFoot, ImageFoot> transition(ImageFoot a, ImageFoot b, const Differ &differ) const;

    const ImageSurface &m_on;
    const SpaceCurve &m_curve;
    double m_tolerance;
    Eigen::Vector2d m_low;
    Eigen::Vector2d m_high;
    bool m_closed[2] = {false, false};
    double m_speeds[2] = {0.0, 0.0};
    double m_speed = 0.0;
    std::vector<double> m_corners;
};

} // namespace laminate_offset
