// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest points of trimmed faces with a closed form, against dense samples of the inside and of the loops. The oracle shares
// nothing with the engine: the inside is that of polygons of the pcurves, samples come from OpenCASCADE's surface.
#include "support/random_cases.h"

#include <laminate_offset/nearest_point.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace laminate_offset;
using test_support::RandomCases;

namespace
{

constexpr int polygon_sides = 1000;
constexpr int grid = 80;

//! An ellipse in the parameters; as a hole it is run through the other way.
struct Oval
{
    gp_Pnt2d middle;
    double half_u = 1.0;
    double half_v = 1.0;
};

TopoDS_Wire wire_of(const Oval &oval, const Handle(Geom_Surface) & surface, bool hole)
{
    const bool wide = oval.half_u >= oval.half_v;
    const gp_Ax22d axes(oval.middle, wide ? gp_Dir2d(1, 0) : gp_Dir2d(0, 1), true);
    const Handle(Geom2d_Curve) curve =
        new Geom2d_Ellipse(axes, std::max(oval.half_u, oval.half_v), std::min(oval.half_u, oval.half_v));
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(curve, surface);
    BRepLib::BuildCurve3d(edge, 1e-9);
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge);
    return hole ? TopoDS::Wire(wire.Reversed()) : wire;
}

TopoDS_Face oval_face(const Handle(Geom_Surface) & surface, const Oval &border, const std::vector<Oval> &holes)
{
    BRepBuilderAPI_MakeFace maker(surface, wire_of(border, surface, false), true);
    for (const Oval &hole : holes)
        maker.Add(wire_of(hole, surface, true));
    return maker.Face();
}

TopoDS_Face box_face(const Handle(Geom_Surface) & surface, const std::array<double, 4> &box,
                     const std::vector<Oval> &holes)
{
    BRepBuilderAPI_MakeFace maker(surface, box[0], box[1], box[2], box[3], 1e-9);
    for (const Oval &hole : holes)
        maker.Add(wire_of(hole, surface, true));
    return maker.Face();
}

//! A trimmed face as polygons and samples.
class DenseFace
{
public:
    explicit DenseFace(const TopoDS_Face &face) : m_surface(BRep_Tool::Surface(face))
    {
        for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next())
            for (TopExp_Explorer edge(wire.Current(), TopAbs_EDGE); edge.More(); edge.Next())
            {
                double first = 0.0, last = 0.0;
                const auto pcurve = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), face, first, last);
                m_lines.emplace_back();
                for (int i = 0; i <= polygon_sides; ++i)
                    m_lines.back().push_back(pcurve->Value(first + (last - first) * i / polygon_sides));
            }
        BRepTools::UVBounds(face, m_u0, m_u1, m_v0, m_v1);
        for (int i = 0; i <= grid; ++i)
            for (int j = 0; j <= grid; ++j)
                if (const gp_Pnt2d uv(m_u0 + (m_u1 - m_u0) * i / grid, m_v0 + (m_v1 - m_v0) * j / grid); inside(uv))
                    m_samples.push_back({uv, point(uv)});
        for (const auto &line : m_lines)
            for (const gp_Pnt2d &uv : line)
                m_samples.push_back({uv, point(uv)});
        gp_Pnt low = m_samples.front().point, high = low;
        for (const Sample &s : m_samples)
            for (int e = 1; e <= 3; ++e)
            {
                low.SetCoord(e, std::min(low.Coord(e), s.point.Coord(e)));
                high.SetCoord(e, std::max(high.Coord(e), s.point.Coord(e)));
            }
        m_size = low.Distance(high);
    }

    [[nodiscard]] gp_Pnt point(const gp_Pnt2d &uv) const { return m_surface->Value(uv.X(), uv.Y()); }
    [[nodiscard]] double size() const { return m_size; }
    [[nodiscard]] const std::vector<std::vector<gp_Pnt2d>> &lines() const { return m_lines; }

    [[nodiscard]] bool inside(const gp_Pnt2d &p) const
    {
        bool odd = false;
        for (const auto &line : m_lines)
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                if ((line[i].Y() > p.Y()) != (line[i + 1].Y() > p.Y()))
                    odd ^= line[i].X() + (p.Y() - line[i].Y()) / (line[i + 1].Y() - line[i].Y()) *
                                             (line[i + 1].X() - line[i].X()) >
                           p.X();
        return odd;
    }

    //! How far a place is outside, in space: 0 inside, else the distance to the loops' polygons.
    [[nodiscard]] double outside_by(const gp_Pnt2d &uv) const
    {
        if (inside(uv))
            return 0.0;
        double least = std::numeric_limits<double>::infinity();
        for (const auto &line : m_lines)
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
            {
                const gp_XY along = line[i + 1].XY() - line[i].XY();
                const double square = along.SquareModulus();
                const double s =
                    square > 0.0 ? std::clamp((uv.XY() - line[i].XY()).Dot(along) / square, 0.0, 1.0) : 0.0;
                least = std::min(least, point(uv).Distance(point(line[i].XY() + s * along)));
            }
        return least;
    }

    //! The least distance of a sample, made smaller by steps of a compass search from the best one inside.
    [[nodiscard]] double least_distance(const gp_Pnt &p) const
    {
        const Sample *best = &m_samples.front();
        for (const Sample &s : m_samples)
            if (s.point.SquareDistance(p) < best->point.SquareDistance(p))
                best = &s;
        gp_Pnt2d uv = best->uv;
        double least = best->point.Distance(p);
        double du = (m_u1 - m_u0) / grid;
        double dv = (m_v1 - m_v0) / grid;
        for (int halving = 0; halving < 30;)
        {
            bool moved = false;
            for (const auto &[x, y] : {std::pair{du, 0.0}, {-du, 0.0}, {0.0, dv}, {0.0, -dv}})
                if (const gp_Pnt2d at(uv.X() + x, uv.Y() + y);
                    inside(at) && point(at).Distance(p) < least - 1e-12 * m_size)
                {
                    least = point(at).Distance(p);
                    uv = at;
                    moved = true;
                    break;
                }
            if (moved)
                continue;
            du *= 0.5;
            dv *= 0.5;
            ++halving;
        }
        return least;
    }

private:
    struct Sample
    {
        gp_Pnt2d uv;
        gp_Pnt point;
    };
    Handle(Geom_Surface) m_surface;
    std::vector<std::vector<gp_Pnt2d>> m_lines;
    std::vector<Sample> m_samples;
    double m_u0 = 0.0, m_u1 = 0.0, m_v0 = 0.0, m_v1 = 0.0;
    double m_size = 0.0;
};

struct TrimmedCase
{
    const char *name;
    TopoDS_Face face;
    std::vector<gp_Pnt> special; //!< on the axis, at the apex, at centres, on the seam's side
};

//! On the axis of a frame, through the apex of a cone, through centres, and opposite to the seam.
std::vector<gp_Pnt> around_axis(const gp_Ax3 &frame, const std::vector<double> &heights, double radius)
{
    std::vector<gp_Pnt> points;
    const gp_Vec x(frame.XDirection());
    for (const double z : heights)
    {
        const gp_Pnt on = frame.Location().Translated(z * gp_Vec(frame.Direction()));
        for (const double r : {0.0, 0.5 * radius, -0.5 * radius, radius, 1.7 * radius, -2.0 * radius})
            points.push_back(on.Translated(r * x));
    }
    return points;
}

std::vector<TrimmedCase> trimmed_cases()
{
    const gp_Ax3 frame(gp_Pnt(12, -5, 7), gp_Dir(1, 2, 3), gp_Dir(2, -1, 0));
    const gp_Ax1 axis(frame.Location(), frame.Direction());
    const auto at = [&](double r, double z) {
        return frame.Location().Translated(r * gp_Vec(frame.XDirection()) + z * gp_Vec(frame.Direction()));
    };
    const Handle(Geom_Surface) plane = new Geom_Plane(frame);
    const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(frame, 25.0);
    const Handle(Geom_Surface) cone = new Geom_ConicalSurface(frame, 0.5, 20.0);
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(frame, 40.0);
    const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(frame, 60.0, 15.0);
    const gp_Ax2 round(frame.Location(), frame.Direction(), frame.XDirection());
    const Handle(Geom_Surface) tube = new Geom_SurfaceOfLinearExtrusion(new Geom_Circle(round, 25.0), axis.Direction());
    const Handle(Geom_Surface) funnel =
        new Geom_SurfaceOfRevolution(new Geom_Line(at(30.0, 0.0), gp_Dir(gp_Vec(at(30.0, 0.0), at(45.0, 30.0)))), axis);
    const gp_Ax2 meridian(at(60.0, 5.0), frame.YDirection(), frame.XDirection());
    const Handle(Geom_Surface) ring = new Geom_SurfaceOfRevolution(new Geom_Circle(meridian, 15.0), axis);
    const double apex = -20.0 / std::sin(0.5); // v there
    const double turn = 2.0 * M_PI;
    const auto about = [&](const std::vector<double> &heights, double radius) {
        return around_axis(frame, heights, radius);
    };
    const std::vector<double> low{-30.0, 0.0, 9.0, 40.0};
    return {
        {"oval of a plane", oval_face(plane, {{3, 4}, 30, 12}, {{{8, 6}, 5, 3}}), about(low, 20.0)},
        {"oval of a cylinder, over the seam", oval_face(cylinder, {{6.0, 5}, 1.2, 18}, {{{6.4, 3}, 0.3, 6}}),
         about(low, 25.0)},
        {"whole cylinder with holes",
         box_face(cylinder, {0, turn, -10, 30}, {{{1.5, 10}, 1.0, 8}, {{4.0, 12}, 0.2, 14}}), about(low, 25.0)},
        {"oval of a cone", oval_face(cone, {{2, 10}, 1.5, 18}, {}), about({-20.0 / std::tan(0.5), 0.0, 20.0}, 20.0)},
        {"cone to its apex with a hole", box_face(cone, {0, turn, apex, 30}, {{{3, -5}, 1.4, 20}}),
         about({-20.0 / std::tan(0.5), -50.0, 0.0, 20.0}, 20.0)},
        {"oval of a sphere", oval_face(sphere, {{1, 0.3}, 1.3, 0.8}, {{{1.2, 0.4}, 0.3, 0.2}}),
         about({-40.0, 0.0, 40.0, 55.0}, 40.0)},
        {"whole sphere with holes", box_face(sphere, {0, turn, -M_PI_2, M_PI_2}, {{{2, 0.2}, 1.5, 1.1}}),
         about({-70.0, -40.0, 0.0, 40.0, 70.0}, 40.0)},
        {"cap with its pole", box_face(sphere, {0, turn, 0.4, M_PI_2}, {{{2, 1.0}, 0.8, 0.3}}),
         about({-40.0, 0.0, 40.0, 70.0}, 40.0)},
        {"oval of a torus, over both seams", oval_face(torus, {{6.2, 6.1}, 1.4, 1.7}, {{{6.0, 6.0}, 0.5, 0.6}}),
         about({-15.0, 0.0, 15.0}, 60.0)},
        {"whole torus with a hole", box_face(torus, {0, turn, 0, turn}, {{{3, 3}, 1.5, 1.8}}),
         about({-15.0, 0.0, 15.0}, 60.0)},
        {"oval of an extruded circle", oval_face(tube, {{3.0, 5}, 1.2, 18}, {{{3.4, 3}, 0.3, 6}}), about(low, 25.0)},
        {"oval of a revolved line", oval_face(funnel, {{3.0, 10}, 1.9, 18}, {{{3.4, 12}, 0.3, 3}}), about(low, 40.0)},
        {"oval of a revolved circle", oval_face(ring, {{3.0, 3}, 1.9, 2.2}, {{{3.4, 3}, 0.3, 0.9}}),
         about({-15.0, 5.0, 15.0}, 60.0)},
    };
}

//! Points about the face: on it, beside its loops on both sides of the surface, and anywhere.
std::vector<gp_Pnt> points_about(const DenseFace &dense, const TrimmedCase &made, RandomCases &random)
{
    std::vector<gp_Pnt> points = made.special;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(made.face);
    for (const auto &line : dense.lines())
        for (int i = 0; i < 8; ++i)
        {
            const gp_Pnt2d uv = line[static_cast<std::size_t>(random.integer(0, polygon_sides))];
            gp_Pnt s;
            gp_Vec su, sv;
            surface->D1(uv.X(), uv.Y(), s, su, sv);
            const gp_Vec normal = su.Crossed(sv);
            const double side = random.sign() * random.magnitude(1e-6, 0.5) * dense.size();
            const gp_Vec away = normal.Magnitude() > 1e-9 ? side / normal.Magnitude() * normal : gp_Vec(0, 0, side);
            points.push_back(s);
            points.push_back(s.Translated(away));
        }
    const gp_Pnt middle = points.back();
    for (int i = 0; i < 20; ++i)
        points.push_back(middle.Translated(
            dense.size() * gp_Vec(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))));
    return points;
}

} // namespace

TEST(TrimmedNearestPoint, NothingInsideTheLoopsIsNearer)
{
    RandomCases random;
    int held = 0, inner = 0;
    for (const TrimmedCase &made : trimmed_cases())
    {
        SCOPED_TRACE(made.name);
        const DenseFace dense(made.face);
        const std::vector<gp_Pnt> points = points_about(dense, made, random);
        const auto found = nearest_points(made.face, points, true);
        const auto whole = nearest_points(made.face, points, false);
        ASSERT_TRUE(found.ok() && whole.ok());
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            SCOPED_TRACE(i);
            const NearestPoint &foot = found.value()[i];
            EXPECT_LE(dense.point(foot.uv).Distance(foot.point), 1e-11 * dense.size());
            EXPECT_NEAR(foot.point.Distance(points[i]), foot.distance, 1e-11 * dense.size());
            EXPECT_LE(dense.outside_by(foot.uv), 3e-5 * dense.size()) << "the polygon's sag is below that";
            EXPECT_LE(foot.distance, dense.least_distance(points[i]) + 5e-6 * dense.size());
            EXPECT_GE(foot.distance, whole.value()[i].distance - 1e-11 * dense.size());
            const bool by_loops = foot.distance > whole.value()[i].distance + 1e-6 * dense.size();
            ++(by_loops ? held : inner);
        }
    }
    EXPECT_GT(held, 200);
    EXPECT_GT(inner, 200);
}
