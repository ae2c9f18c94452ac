// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve_image.h"

#include "image_marcher.h"

#include "../spline/geom_values.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace laminate_offset
{
namespace
{

constexpr int deepest = 26;
// A curve that needs more of them is not followed any better by cubics.
constexpr std::size_t most_cubics = 10000;
// Parts of the tolerance for the cubics, tried in turn.
constexpr double fit_shares[] = {0.3, 0.05};
// A bridge needs room beside the jump: so many times what it costs in distance is told.
constexpr double bridging = 1.25;
constexpr int bridge_probes = 64;
// Where the way across is not what fails: so many times the tolerance is told at least.
constexpr double more_tolerance = 2.0;
// A bridge may be farther from the curve than the nearest point by this part of the distance, whatever the tolerance.
constexpr double bridge_share = 0.1;
// Places between two knots of an image where its distance from the curve is measured.
constexpr int places_per_span = 8;
// Part of the tolerance that taking out knots may cost.
constexpr double removal_share = 0.2;
// A curve within this part of the tolerance of the surface may stay the edge's own curve.
constexpr double on_surface_share = 0.7;

//! A cubic piece with its Bezier points (eq. 3.13).
struct Cubic
{
    double low = 0.0;
    double high = 0.0;
    Eigen::Vector2d q[4];

    [[nodiscard]] Eigen::Vector2d value(double t) const
    {
        const double x = (t - low) / (high - low);
        const double y = 1.0 - x;
        return y * y * y * q[0] + 3.0 * x * y * y * q[1] + 3.0 * x * x * y * q[2] + x * x * x * q[3];
    }
};

//! Where the nearest point jumps from one side of a hollow crease to the other.
struct Jump
{
    ImageFoot from;
    double width = 0.0;  //!< [mm]
    double excess = 0.0; //!< how much farther from the curve than its nearest point the way across is [mm]
};

class ImageFitter
{
public:
    //! \param excess a piece over a jump may be farther from the curve than its nearest point by this, or by a share of the
    //! distance [mm]; 0: no such piece.
    ImageFitter(const ImageMarcher &marcher, const ImageSurface &on, double admissible, bool on_surface, double excess)
        : m_marcher(marcher), m_on(on), m_admissible(admissible), m_on_surface(on_surface), m_excess(excess)
    {
    }

    //! False where the tolerance is not reached.
    bool fit(const ImageFoot &start, const ImageFoot &end, int depth)
    {
        const double step = end.t - start.t;
        Cubic cubic{start.t, end.t, {}};
        cubic.q[0] = start.uv;                            // eq. 3.13a
        cubic.q[1] = start.uv + step / 3.0 * start.slope; // eq. 3.13b
        cubic.q[2] = end.uv - step / 3.0 * end.slope;     // eq. 3.13c
        cubic.q[3] = end.uv;                              // eq. 3.13d
        for (Eigen::Vector2d &q : cubic.q)
            q = {std::clamp(q.x(), m_on.box.umin, m_on.box.umax), std::clamp(q.y(), m_on.box.vmin, m_on.box.vmax)};
        if (fits(cubic) || (m_excess > 0.0 && bridges(cubic) && holds_jump(start, end)))
        {
            m_cubics.push_back(cubic);
            return true;
        }
        const double middle = 0.5 * (start.t + end.t);
        if (depth >= deepest || m_cubics.size() >= most_cubics || !(middle > start.t && middle < end.t))
        {
            if (const double width = (end.point - start.point).norm(); depth >= deepest && width > m_admissible)
                m_jump = Jump{start, width, excess_between(start, end)};
            return false;
        }
        const ImageFoot between = m_marcher.foot(middle, 0.5 * (start.uv + end.uv));
        return fit(start, between, depth + 1) && fit(between, end, depth + 1);
    }

    //! Why fit() failed, if it did so for that reason.
    [[nodiscard]] const std::optional<Jump> &jump() const { return m_jump; }

    //! The cubics as one curve, with what is not C1 at its corners.
    [[nodiscard]] Handle(Geom2d_BSplineCurve) curve(const std::vector<double> &corners) const
    {
        std::vector<Eigen::Vector2d> poles{m_cubics.front().q[0]};
        TColStd_Array1OfReal knots(1, static_cast<int>(m_cubics.size()) + 1);
        TColStd_Array1OfInteger multiplicities(1, knots.Length());
        for (std::size_t i = 0; i < m_cubics.size(); ++i)
        {
            const Cubic &cubic = m_cubics[i];
            const bool last = i + 1 == m_cubics.size();
            const bool corner =
                last || std::binary_search(corners.begin(), corners.end(), cubic.high) || clamped_beside(i);
            poles.insert(poles.end(), {cubic.q[1], cubic.q[2]});
            if (corner)
                poles.push_back(cubic.q[3]);
            knots(static_cast<int>(i) + 1) = cubic.low;
            multiplicities(static_cast<int>(i) + 2) = last ? 4 : corner ? 3 : 2;
        }
        knots(knots.Upper()) = m_cubics.back().high;
        multiplicities(1) = 4;
        TColgp_Array1OfPnt2d points(1, static_cast<int>(poles.size()));
        for (int i = 1; i <= points.Upper(); ++i)
            points(i) =
                gp_Pnt2d(poles[static_cast<std::size_t>(i) - 1].x(), poles[static_cast<std::size_t>(i) - 1].y());
        return new Geom2d_BSplineCurve(points, knots, multiplicities, 3);
    }

private:
    //! Points kept inside the box no longer stand for the slope; the pieces then meet with C0 only.
    [[nodiscard]] bool clamped_beside(std::size_t i) const
    {
        const Cubic &a = m_cubics[i];
        const Cubic &b = m_cubics[i + 1];
        const Eigen::Vector2d before = (a.q[3] - a.q[2]) / (a.high - a.low);
        const Eigen::Vector2d after = (b.q[1] - b.q[0]) / (b.high - b.low);
        return (before - after).norm() > 1e-9 * (before.norm() + after.norm());
    }

    [[nodiscard]] bool fits(const Cubic &cubic) const
    {
        for (const double x : {0.15, 0.35, 0.5, 0.65, 0.85})
        {
            const double t = cubic.low + x * (cubic.high - cubic.low);
            const Eigen::Vector2d uv = cubic.value(t);
            const Eigen::Vector3d target = m_on_surface ? m_marcher.given(t) : m_marcher.foot(t, uv).point;
            if (!((point(uv) - target).norm() <= m_admissible))
                return false;
        }
        return true;
    }

    [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector2d &uv) const
    {
        return vector(m_on.surface->Value(uv.x(), uv.y()).XYZ());
    }

    //! Is the image all along about as near to the curve as the surface is?
    [[nodiscard]] bool bridges(const Cubic &cubic) const
    {
        for (int k = 1; k < bridge_probes; ++k)
        {
            const double t = cubic.low + (cubic.high - cubic.low) * k / bridge_probes;
            const Eigen::Vector2d uv = cubic.value(t);
            const double least = m_marcher.foot(t, uv).distance;
            if (!((point(uv) - m_marcher.given(t)).norm() <= least + std::max(m_excess, bridge_share * least)))
                return false;
        }
        return true;
    }

    //! Does the nearest point jump between two places of the curve? The half is taken where its ends lie farther apart.
    [[nodiscard]] bool holds_jump(ImageFoot start, ImageFoot end) const
    {
        for (int depth = 0; depth < deepest; ++depth)
        {
            const double middle = 0.5 * (start.t + end.t);
            if ((end.point - start.point).norm() <= m_admissible || !(middle > start.t && middle < end.t))
                return false;
            const ImageFoot between = m_marcher.foot(middle, 0.5 * (start.uv + end.uv));
            const bool first = (between.point - start.point).norm() >= (end.point - between.point).norm();
            (first ? end : start) = between;
        }
        return (end.point - start.point).norm() > m_admissible;
    }

    //! Of the straight line in the parameters between the feet of one and the same point of the curve.
    [[nodiscard]] double excess_between(const ImageFoot &a, const ImageFoot &b) const
    {
        const Eigen::Vector3d given = m_marcher.given(a.t);
        double farthest = a.distance;
        for (int k = 1; k < bridge_probes; ++k)
            farthest = std::max(farthest, (point(a.uv + (b.uv - a.uv) * k / bridge_probes) - given).norm());
        return farthest - a.distance;
    }

    const ImageMarcher &m_marcher;
    const ImageSurface &m_on;
    double m_admissible;
    bool m_on_surface;
    double m_excess;
    std::vector<Cubic> m_cubics;
    std::optional<Jump> m_jump;
};

//! Takes out knots as far as the curve stays within `admissible` in its parameters.
Handle(Geom2d_BSplineCurve) simplified(const Handle(Geom2d_BSplineCurve) & curve, double admissible)
{
    const auto result = Handle(Geom2d_BSplineCurve)::DownCast(curve->Copy());
    const double each = admissible / std::max(1, curve->NbKnots());
    for (int i = result->NbKnots() - 1; i > 1; --i)
        for (int m = result->Multiplicity(i) - 1; m >= 0; --m)
            if (!result->RemoveKnot(i, m, each))
                break;
    return result;
}

//! With the poles kept inside a box: taking out knots moves them a little beyond the surface's ends, where nothing can be
//! proven.
Handle(Geom2d_BSplineCurve) kept_inside(const Handle(Geom2d_BSplineCurve) & curve, const ParameterBox &box)
{
    for (int i = 1; i <= curve->NbPoles(); ++i)
    {
        const gp_Pnt2d pole = curve->Pole(i);
        curve->SetPole(i, gp_Pnt2d(std::clamp(pole.X(), box.umin, box.umax), std::clamp(pole.Y(), box.vmin, box.vmax)));
    }
    return curve;
}

//! Two digits of a number above zero, rounded up.
double rounded_up(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return unit * std::ceil(value / unit);
}

class ImageMaker
{
public:
    ImageMaker(const ImageSurface &on, const SpaceCurve &curve, double tolerance)
        : m_on(on), m_curve(curve), m_marcher(on, curve, tolerance), m_tolerance(tolerance)
    {
    }

    [[nodiscard]] Result<std::vector<ImagePiece>> make() const
    {
        std::vector<ImagePiece> pieces;
        for (const ImageRun &run : m_marcher.runs(true))
        {
            std::optional<Jump> jump;
            std::optional<ImagePiece> piece = image(run, jump);
            if (!piece)
                return refusal(run, jump);
            pieces.push_back(std::move(*piece));
        }
        return pieces;
    }

    //! Only the image, of a curve that stays in one piece.
    [[nodiscard]] Handle(Geom2d_BSplineCurve) dropped() const
    {
        const std::vector<ImageRun> runs = m_marcher.runs(false);
        if (runs.size() != 1)
            return {};
        const double part = fit_shares[0];
        std::optional<Jump> jump;
        const Handle(Geom2d_BSplineCurve) fitted = hermite_pieces(runs.front(), {part * m_tolerance, false, 0.0}, jump);
        return fitted.IsNull() ? fitted : simplified(fitted, removal_share * m_tolerance / m_marcher.speed());
    }

private:
    [[nodiscard]] Failure refusal(const ImageRun &run, const std::optional<Jump> &jump) const
    {
        if (!jump)
            return {Status::EdgeToleranceNotReached, Stage::Trimming,
                    fmt::format("The image of the curve between its parameters {:.6g} and {:.6g} could not be "
                                "brought within {:.3g} mm; ask for a larger tolerance.",
                                run.feet.front().t, run.feet.back().t, m_tolerance),
                    std::nullopt, std::nullopt};
        const ImageFoot &at = jump->from;
        return {
            Status::EdgeToleranceNotReached, Stage::Trimming,
            fmt::format("At its parameter {:.6g} the curve is {:.3g} mm away from the surface, and its nearest point "
                        "jumps by {:.3g} mm over a hollow crease; bring the curve nearer to the surface, or ask for "
                        "a tolerance of {:.2g} mm or more, by which the image may be farther from the curve than "
                        "the nearest points where it crosses the crease.",
                        at.t, at.distance, jump->width,
                        rounded_up(std::max(bridging * jump->excess, more_tolerance * m_tolerance))),
            Where{gp_Pnt2d(at.uv.x(), at.uv.y()), gp_Pnt(at.point.x(), at.point.y(), at.point.z())}, std::nullopt};
    }

    //! How near the cubics have to come; see ImageFitter.
    struct Demand
    {
        double admissible = 0.0;
        bool on_surface = false;
        double excess = 0.0;
    };

    //! Null where the cubics do not come as near.
    [[nodiscard]] Handle(Geom2d_BSplineCurve)
        hermite_pieces(const ImageRun &run, const Demand &demand, std::optional<Jump> &jump) const
    {
        ImageFitter fitter(m_marcher, m_on, demand.admissible, demand.on_surface, demand.excess);
        for (std::size_t i = 0; i + 1 < run.feet.size(); ++i)
            if (!fitter.fit(run.feet[i], run.feet[i + 1], 0))
            {
                jump = fitter.jump();
                return {};
            }
        return fitter.curve(run.corners);
    }

    [[nodiscard]] std::optional<ImagePiece> image(const ImageRun &run, std::optional<Jump> &jump) const
    {
        double distance = 0.0;
        for (const ImageFoot &foot : run.feet)
            distance = std::max(distance, foot.distance);
        for (const bool on_surface : {true, false})
            for (const double share : fit_shares)
            {
                if (on_surface && distance > on_surface_share * m_tolerance)
                    continue;
                const double room = on_surface ? m_tolerance - distance : m_tolerance;
                const Demand demand{(on_surface ? distance : 0.0) + share * room, on_surface, 0.0};
                if (std::optional<ImagePiece> piece = piece_of(run, demand, share * room, distance, jump))
                    return piece;
            }
        if (jump)
            for (const double share : fit_shares)
            {
                const double part = share * m_tolerance;
                if (std::optional<ImagePiece> piece = piece_of(run, {part, false, m_tolerance}, part, distance, jump))
                {
                    piece->bridged = true;
                    return piece;
                }
            }
        return std::nullopt;
    }

    //! \param distance largest one of the feet [mm].
    [[nodiscard]] std::optional<ImagePiece> piece_of(const ImageRun &run, const Demand &demand, double room,
                                                     double distance, std::optional<Jump> &jump) const
    {
        const Handle(Geom2d_BSplineCurve) cubics = hermite_pieces(run, demand, jump);
        if (cubics.IsNull())
            return std::nullopt;
        std::optional<ImagePiece> piece = proven(cubics, demand.on_surface, room);
        if (!piece)
            return std::nullopt;
        piece->distance = std::max(distance, distance_seen(*piece));
        piece->distance_bound = proven_distance(*piece);
        return piece;
    }

    //! Of the given curve from its image.
    [[nodiscard]] std::optional<double> proven_distance(const ImagePiece &piece) const
    {
        Deviation deviation = piece.deviation; // of the given curve itself, on the surface
        if (!piece.on_surface)
        {
            const EdgeTarget target({m_on.proof_surface, piece.pcurve, piece.first, piece.last}, m_on.form);
            deviation = target.deviation(m_curve.curve, std::max(m_tolerance, piece.distance));
            deviation.bound += m_on.model_error;
        }
        return deviation.proven ? std::optional<double>(deviation.bound) : std::nullopt;
    }

    //! Of the given curve from its image, between the image's knots: feet alone miss where it leaves the surface.
    [[nodiscard]] double distance_seen(const ImagePiece &piece) const
    {
        const Geom2dAdaptor_Curve adaptor(piece.pcurve, piece.first, piece.last);
        TColStd_Array1OfReal ends(1, adaptor.NbIntervals(GeomAbs_CN) + 1);
        adaptor.Intervals(ends, GeomAbs_CN);
        double distance = 0.0;
        for (int i = 1; i < ends.Upper(); ++i)
            for (int k = 0; k <= places_per_span; ++k)
            {
                const double t = ends(i) + (ends(i + 1) - ends(i)) * k / places_per_span;
                const gp_Pnt2d uv = piece.pcurve->Value(t);
                const gp_Pnt image = m_on.surface->Value(uv.X(), uv.Y());
                distance = std::max(distance, image.Distance(m_curve.curve->Value(t)));
            }
        return distance;
    }

    //! With as few knots as the proof admits; where nothing can be proven, as samples admit.
    [[nodiscard]] std::optional<ImagePiece> proven(const Handle(Geom2d_BSplineCurve) & pcurve, bool on_surface,
                                                   double room) const
    {
        const double admissible = removal_share * room / m_marcher.speed();
        std::optional<ImagePiece> seen;
        for (const Handle(Geom2d_Curve) & candidate :
             {Handle(Geom2d_Curve)(kept_inside(simplified(pcurve, admissible), m_on.box)),
              Handle(Geom2d_Curve)(pcurve)})
        {
            ImagePiece piece{
                candidate, {}, candidate->FirstParameter(), candidate->LastParameter(), {}, on_surface, 0.0, {}, false};
            const EdgeTarget target({m_on.proof_surface, candidate, piece.first, piece.last}, m_on.form);
            const double left = m_tolerance - m_on.model_error;
            if (on_surface)
            {
                piece.curve = m_curve.curve;
                piece.deviation = target.deviation(m_curve.curve, left);
            }
            else if (std::optional<EdgeCurve> own = edge_curve(target, left))
            {
                piece.curve = own->curve;
                piece.deviation = own->deviation;
            }
            piece.deviation.bound += m_on.model_error;
            if (piece.curve.IsNull() || !(piece.deviation.bound <= m_tolerance))
                continue;
            if (piece.deviation.proven)
                return piece;
            if (!seen)
                seen = piece;
        }
        return seen;
    }

    const ImageSurface &m_on;
    const SpaceCurve &m_curve;
    ImageMarcher m_marcher;
    double m_tolerance;
};

} // namespace

Result<std::vector<ImagePiece>> image_of(const ImageSurface &on, const SpaceCurve &curve, double tolerance)
{
    return ImageMaker(on, curve, tolerance).make();
}

Handle(Geom2d_Curve) dropped_pcurve(const ImageSurface &on, const SpaceCurve &curve, double accuracy)
{
    return ImageMaker(on, curve, accuracy).dropped();
}

} // namespace laminate_offset
