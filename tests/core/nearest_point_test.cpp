// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest points against their definition: no sample of the surface is nearer, and what comes back is on the surface.
#include "support/data_files.h"
#include "support/sample_faces.h"

#include <laminate_offset/analysis/analytic_form.h>
#include <laminate_offset/nearest/face_nearest.h>
#include <laminate_offset/nearest_point.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

using namespace laminate_offset;

namespace
{

struct Named
{
    const char *name;
    TopoDS_Face face;
};

TopoDS_Face part_of(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1)
{
    return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7);
}

std::vector<Named> faces()
{
    const gp_Ax3 frame(gp_Pnt(10, -4, 3), gp_Dir(1, 2, 3), gp_Dir(2, -1, 0));
    const auto bumpy = test_support::height_surface(
        [](double x, double y) { return 30.0 * std::sin(0.02 * x) * std::cos(0.03 * y); }, 400.0, 250.0, 12, 9);
    const Handle(Geom_Curve) ellipse = new Geom_Ellipse(gp_Ax2(gp_Pnt(90, 0, 0), gp_Dir(0, 1, 0)), 40.0, 15.0);
    const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    return {
        {"bumpy spline", BRepBuilderAPI_MakeFace(bumpy, 1e-7)},
        {"closed spline", BRepBuilderAPI_MakeFace(test_support::wavy_tube(50.0), 1e-7)},
        {"plane", part_of(new Geom_Plane(frame), -20, 50, -10, 30)},
        {"cylinder", part_of(new Geom_CylindricalSurface(frame, 25.0), 0.3, 4.0, -10, 30)},
        {"cone with apex", part_of(new Geom_ConicalSurface(frame, 0.5, 20.0), 0, 2 * M_PI, -20.0 / std::sin(0.5), 30)},
        {"sphere", part_of(new Geom_SphericalSurface(frame, 40.0), 0, 2 * M_PI, -M_PI_2, M_PI_2)},
        {"torus", part_of(new Geom_ToroidalSurface(frame, 60.0, 15.0), 1.0, 5.5, 0, 2 * M_PI)},
        {"turned ellipse", part_of(new Geom_SurfaceOfRevolution(ellipse, axis), 0, 2 * M_PI, 0, 2 * M_PI)},
        {"extruded ellipse",
         part_of(new Geom_SurfaceOfLinearExtrusion(ellipse, gp_Dir(1, 1, 1)), 0.2, 5.0, -30.0, 70.0)},
        {"trimmed panel", test_support::panel_with_hole()},
        {"located panel", test_support::located(test_support::panel_with_hole())},
    };
}

//! Points about the face's box, every second one on the surface.
std::vector<gp_Pnt> points_about(const InputFace &input, int count, unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const ParameterBox &box = input.box;
    std::vector<gp_Pnt> points;
    for (int i = 0; i < count; ++i)
    {
        const gp_Pnt on = input
                              .place({box.umin + (box.umax - box.umin) * unit(engine),
                                      box.vmin + (box.vmax - box.vmin) * unit(engine)})
                              .point;
        const double away = i % 2 == 0 ? 0.0 : 2.0 * input.diagonal;
        points.push_back(on.Translated(
            gp_Vec(away * (unit(engine) - 0.5), away * (unit(engine) - 0.5), away * (unit(engine) - 0.5))));
    }
    return points;
}

using Wide = Eigen::Matrix<long double, 3, 1>;

Wide wide(const gp_XYZ &p) { return {p.X(), p.Y(), p.Z()}; }
Wide wide(const gp_Pnt &p) { return wide(p.XYZ()); }

//! Points on a grid over the face's box where the face stands; if trimmed, those inside the loops by OpenCASCADE.
std::vector<gp_Pnt> grid_points(const InputFace &input, bool trimmed)
{
    constexpr int grid = 40;
    const BRepTopAdaptor_FClass2d inside(input.face, 1e-9);
    const ParameterBox &b = input.box;
    std::vector<gp_Pnt> points;
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            const gp_Pnt2d uv(b.umin + (b.umax - b.umin) * i / grid, b.vmin + (b.vmax - b.vmin) * j / grid);
            if (!trimmed || inside.Perform(uv, false) == TopAbs_IN)
                points.push_back(input.place(uv).point);
        }
    return points;
}

double least_on_grid(const InputFace &input, const gp_Pnt &point)
{
    constexpr int grid = 60;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= grid; ++i)
        for (int j = 0; j <= grid; ++j)
        {
            const ParameterBox &b = input.box;
            const gp_Pnt2d uv(b.umin + (b.umax - b.umin) * i / grid, b.vmin + (b.vmax - b.vmin) * j / grid);
            least = std::min(least, input.place(uv).point.Distance(point));
        }
    return least;
}

//! A plane, or a line or a circle turned about an axis, as its own kind or as a surface of revolution.
struct ClosedCase
{
    TopoDS_Face face;
    std::vector<gp_Pnt> special; //!< on the axis, at centres, opposite to the middle
};

ClosedCase closed_case(int round, std::mt19937 &engine)
{
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
    gp_Ax3 frame(gp_Pnt(uniform(-50, 50), uniform(-50, 50), uniform(-50, 50)), gp_Dir(1, uniform(-2, 2), 0.5),
                 gp_Dir(uniform(-1, 1), 1, uniform(-1, 1)));
    if (round % 2 == 1)
        frame.YReverse();
    const double u0 = uniform(-7.0, 7.0);
    const double u1 = u0 + (round % 3 == 0 ? 2.0 * M_PI : uniform(0.1, 6.0));
    const gp_Ax1 axis(frame.Location(), frame.Direction());
    const auto at = [&](double r, double z) {
        return frame.Location().Translated(r * gp_Vec(frame.XDirection()) + z * gp_Vec(frame.Direction()));
    };
    ClosedCase result;
    for (const double z : {-200.0, -31.0, 0.0, 5.0, 12.0})
        result.special.insert(result.special.end(), {at(0.0, z), at(-70.0, z), at(60.0, z)});
    const gp_Ax2 meridian(at(60.0, 5.0), frame.YDirection(), frame.XDirection());
    const gp_Dir slant(gp_Vec(at(30.0, 0.0), at(uniform(25, 60), 30.0)));
    const double top = round % 4 == 0 ? uniform(-0.5, 1.2) : M_PI_2;
    switch (round % 7)
    {
    case 0: result.face = part_of(new Geom_Plane(frame), uniform(-9, 0), uniform(1, 9), -5.0, uniform(1, 9)); break;
    case 1: result.face = part_of(new Geom_CylindricalSurface(frame, uniform(1, 90)), u0, u1, -20.0, 30.0); break;
    case 2: // some of them past the apex
        result.face = part_of(new Geom_ConicalSurface(frame, uniform(-1.2, 1.2), 20.0), u0, u1, uniform(-90, 0), 60.0);
        break;
    case 3:
        result.face =
            part_of(new Geom_SphericalSurface(frame, uniform(1, 90)), u0, u1, round % 2 ? -M_PI_2 : -1.0, top);
        break;
    case 4: result.face = part_of(new Geom_ToroidalSurface(frame, 60.0, uniform(5, 50)), u0, u1, -1.0, top); break;
    case 5:
        result.face =
            part_of(new Geom_SurfaceOfRevolution(new Geom_Line(at(30.0, 0.0), slant), axis), u0, u1, -20.0, 15.0);
        break;
    default:
        result.face = part_of(new Geom_SurfaceOfRevolution(new Geom_Circle(meridian, uniform(5, 40)), axis), u0, u1,
                              uniform(0.0, 1.0), uniform(1.5, 6.0));
    }
    return result;
}

} // namespace

TEST(NearestPoint, NothingOnTheSurfaceIsNearer)
{
    for (const Named &named : faces())
    {
        SCOPED_TRACE(named.name);
        const Result<InputFace> input = read_face(named.face);
        ASSERT_TRUE(input.ok());
        const std::vector<gp_Pnt> points = points_about(input.value(), 200, 5);
        const auto found = nearest_points(named.face, points);
        ASSERT_TRUE(found.ok()) << found.failure().message;
        const double small = 1e-11 * input.value().diagonal;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const NearestPoint &foot = found.value()[i];
            EXPECT_LE(input.value().place(foot.uv).point.Distance(foot.point), 100 * small);
            EXPECT_NEAR(foot.point.Distance(points[i]), foot.distance, small);
            EXPECT_LE(foot.distance, least_on_grid(input.value(), points[i]) + small);
            EXPECT_LE(foot.distance, i % 2 == 0 ? small : std::numeric_limits<double>::infinity());
        }
    }
}

TEST(NearestPoint, NeverFartherThanOpenCascade)
{
    for (const Named &named : faces())
    {
        SCOPED_TRACE(named.name);
        const Result<InputFace> input = read_face(named.face);
        const std::vector<gp_Pnt> points = points_about(input.value(), 300, 9);
        const auto found = nearest_points(named.face, points);
        TopLoc_Location location;
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(named.face);
        const ParameterBox &b = input.value().box;
        int compared = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const GeomAPI_ProjectPointOnSurf other(points[i], surface, b.umin, b.umax, b.vmin, b.vmax);
            if (other.NbPoints() == 0)
                continue;
            ++compared;
            EXPECT_LE(found.value()[i].distance, other.LowerDistance() + 1e-9 * input.value().diagonal);
        }
        EXPECT_GT(compared, 100);
    }
}

TEST(NearestPoint, TrimmedFacesAgreeWithTheirShape)
{
    const TopoDS_Face face = test_support::located(test_support::panel_with_hole());
    const Result<InputFace> input = read_face(face);
    const std::vector<gp_Pnt> points = points_about(input.value(), 120, 3);
    const auto found = nearest_points(face, points, true);
    const auto whole = nearest_points(face, points, false);
    ASSERT_TRUE(found.ok() && whole.ok());
    int moved = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const BRepExtrema_DistShapeShape other(BRepBuilderAPI_MakeVertex(points[i]).Vertex(), face);
        EXPECT_NEAR(found.value()[i].distance, other.Value(), 1e-6 * input.value().diagonal);
        EXPECT_GE(found.value()[i].distance, whole.value()[i].distance - 1e-8);
        moved += found.value()[i].distance > whole.value()[i].distance + 1e-3 ? 1 : 0;
    }
    EXPECT_GT(moved, 0);
}

TEST(NearestPoint, EquallyNearPointsEndTheSearch)
{
    const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 40.0);
    const TopoDS_Face face = part_of(sphere, 0, 2 * M_PI, -M_PI_2, M_PI_2);
    const std::vector<gp_Pnt> points{gp_Pnt(0, 0, 0), gp_Pnt(1e-9, 0, 0), gp_Pnt(0, 0, 100), gp_Pnt(0, 0, 40)};
    const auto found = nearest_points(face, points);
    ASSERT_TRUE(found.ok());
    const InputFace input = read_face(face).value();
    const FaceNearest both = FaceNearest::make(input, false).value(); // whose search knows nothing of spheres
    const double expected[] = {40.0, 40.0 - 1e-9, 60.0, 0.0};
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        EXPECT_NEAR(found.value()[i].distance, expected[i], 1e-9);
        const Eigen::Vector3d q(points[i].X(), points[i].Y(), points[i].Z());
        EXPECT_NEAR(both.search().nearest(q).distance, expected[i], 1e-9);
    }
}

//! The closed forms against the general search, which shares nothing with them, and against the surface: all kinds, whole
//! and partial turns, both hands, cones past their apex, points on the axis, at centres, poles, seams and corners.
TEST(NearestPoint, ClosedFormsAgreeWithTheSearch)
{
    std::mt19937 engine(11);
    int disguised = 0, compared = 0;
    for (int round = 0; round < 70; ++round)
    {
        SCOPED_TRACE(round);
        const ClosedCase made = closed_case(round, engine);
        const InputFace input = read_face(made.face).value();
        const FaceNearest closed = FaceNearest::make(input, false).value();
        if (round % 7 < 5)
            ASSERT_TRUE(AnalyticNearest::make(input.surface, domain_box(input, input.surface)).has_value());
        else
            disguised += analytic_form(input).has_value() ? 1 : 0;
        std::vector<gp_Pnt> points = points_about(input, 60, static_cast<unsigned>(round));
        const ParameterBox &b = input.box;
        for (const double u : {b.umin, b.umax})
            for (const double v : {b.vmin, b.vmax})
                points.push_back(input.point({u, v}));
        const std::size_t plain = points.size(); // the others are as far from whole curves, which the search abhors
        points.insert(points.end(), made.special.begin(), made.special.end());
        const double small = 1e-11 * input.diagonal;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const gp_Pnt &p = points[i];
            const Eigen::Vector3d q(p.X(), p.Y(), p.Z());
            const SurfaceFoot foot = closed.nearest(q);
            if (i < plain)
                EXPECT_NEAR(foot.distance, closed.search().nearest(q).distance, 2.0 * small);
            else
                EXPECT_LE(foot.distance, least_on_grid(input, p) + small);
            const gp_Pnt on = input.point({foot.uv.x(), foot.uv.y()});
            EXPECT_LE(on.Distance(gp_Pnt(foot.point.x(), foot.point.y(), foot.point.z())), small);
            EXPECT_NEAR(on.Distance(p), foot.distance, small);
            EXPECT_TRUE(foot.uv.x() >= b.umin - 1e-9 && foot.uv.x() <= b.umax + 1e-9);
            EXPECT_TRUE(foot.uv.y() >= b.vmin - 1e-9 && foot.uv.y() <= b.vmax + 1e-9);
            ++compared;
        }
    }
    EXPECT_GE(disguised, 15);
    EXPECT_GT(compared, 5000);
}

//! From 1e-300 to 1e308 away, in numbers of a longer range. What is compared far away is not the distance L, of which 1e-16
//! may be more than the surface, but |p - q| - L, as (|q - m|^2 / 2 L - (q - m).e) for the middle m and the way e.
TEST(NearestPoint, PointsOfAnyMagnitudeAreRight)
{
    std::mt19937 engine(17);
    std::normal_distribution<double> normal;
    int compared = 0, far = 0;
    for (const Named &named : faces())
        for (const bool trimmed : {false, true})
        {
            SCOPED_TRACE(std::string(named.name) + (trimmed ? " trimmed" : ""));
            const InputFace input = read_face(named.face).value();
            const std::vector<gp_Pnt> grid = grid_points(input, trimmed);
            const gp_Pnt middle = grid[grid.size() / 2];
            std::vector<gp_Pnt> points;
            std::vector<gp_Vec> ways;
            for (int power = -300; power <= 308; power += power >= 2 && power < 12 ? 1 : 2)
            {
                ways.push_back(gp_Vec(normal(engine), normal(engine), normal(engine)).Normalized());
                points.push_back(middle.Translated(std::pow(10.0, power) * ways.back()));
            }
            const auto found = nearest_points(named.face, points, trimmed);
            ASSERT_TRUE(found.ok()) << found.failure().message;
            for (std::size_t i = 0; i < points.size(); ++i)
            {
                const NearestPoint &foot = found.value()[i];
                const long double away = (wide(points[i]) - wide(middle)).stableNorm();
                SCOPED_TRACE(static_cast<double>(away));
                const bool is_far = away > 100.0 * input.diagonal;
                const auto excess = [&](const gp_Pnt &q) -> long double {
                    const Wide from = wide(q) - wide(middle);
                    return is_far ? from.squaredNorm() / (2.0L * away) - from.dot(wide(ways[i].XYZ()))
                                  : (wide(points[i]) - wide(q)).stableNorm();
                };
                long double least = std::numeric_limits<long double>::infinity();
                for (const gp_Pnt &q : grid)
                    least = std::min(least, excess(q));
                const long double rounding = 1e-14L * std::min(away, 1e8L * input.diagonal);
                EXPECT_LE(excess(foot.point), least + 1e-11L * input.diagonal + rounding);
                const long double distance = (wide(points[i]) - wide(foot.point)).stableNorm();
                EXPECT_LE(std::abs(distance - foot.distance), 1e-12L * input.diagonal + 4e-16L * distance);
                ++compared;
                far += is_far ? 1 : 0;
            }
        }
    EXPECT_GT(compared, 6000);
    EXPECT_GT(far, 3000);
}

TEST(NearestPoint, FollowsACurveWithoutJumps)
{
    const Result<InputFace> input = read_face(faces().front().face);
    const Result<FaceNearest> face = FaceNearest::make(input.value(), false);
    ASSERT_TRUE(face.ok());
    const NearestSearch &search = face.value().search();
    Eigen::Vector2d uv(0.02, 0.03);
    for (int i = 0; i <= 100; ++i)
    {
        const Eigen::Vector2d next(0.02 + 0.0096 * i, 0.03 + 0.0093 * i);
        const gp_Pnt p = input.value().point({next.x(), next.y()});
        const SurfaceFoot foot = search.follow({p.X(), p.Y(), p.Z()}, uv);
        EXPECT_LE(foot.distance, 1e-9);
        EXPECT_LE((foot.uv - next).norm(), 1e-9);
        const SurfaceFoot safe = search.nearest({p.X(), p.Y(), p.Z()}, uv);
        EXPECT_LE(safe.distance, 1e-9);
        uv = foot.uv;
    }
}

TEST(NearestPoint, Refusals)
{
    EXPECT_EQ(nearest_points(TopoDS_Shape(), {}).failure().status, Status::NullShape);
    const TopoDS_Face face = faces().front().face;
    std::vector<gp_Pnt> some(3000, gp_Pnt(1, 2, 3));
    for (const std::size_t i : {2900, 1234, 2000})
        some[i].SetY(std::nan(""));
    const auto bad = nearest_points(face, some);
    EXPECT_EQ(bad.failure().status, Status::InvalidOption);
    EXPECT_NE(bad.failure().message.find("Point 1234 "), std::string::npos) << bad.failure().message;
    const double infinity = std::numeric_limits<double>::infinity();
    for (const gp_Pnt &nowhere : {gp_Pnt(infinity, 0, 0), gp_Pnt(0, -infinity, 0), gp_Pnt(1.7e308, -1.7e308, 0)})
        EXPECT_EQ(nearest_points(face, {nowhere}).failure().status, Status::InvalidOption);
    const Handle(Geom_Surface) offset = new Geom_OffsetSurface(BRep_Tool::Surface(face), 5.0);
    const auto procedural = nearest_points(BRepBuilderAPI_MakeFace(offset, 1e-7).Face(), {gp_Pnt(0, 0, 0)});
    EXPECT_EQ(procedural.failure().status, Status::NotSupported);
    EXPECT_TRUE(nearest_points(face, {}).ok());
}

RC_GTEST_PROP(NearestPointProperty, TheFootIsStationaryOrOnTheBorder, ())
{
    const int nu = *rc::gen::inRange(4, 9);
    const int nv = *rc::gen::inRange(4, 9);
    const double bump = *rc::gen::inRange(0, 200);
    const double size = std::pow(10.0, *rc::gen::inRange(-2, 5));
    const auto surface = test_support::height_surface(
        [&](double x, double y) { return bump / 400.0 * size * std::sin(9.0 * x / size) * std::cos(7.0 * y / size); },
        size, size, nu, nv);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-7);
    const auto unit = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
    const gp_Pnt p(unit() * size, unit() * size, unit() * size);
    const auto found = nearest_points(face, {p});
    RC_ASSERT(found.ok());
    const NearestPoint &foot = found.value().front();
    gp_Pnt s;
    gp_Vec su, sv;
    surface->D1(foot.uv.X(), foot.uv.Y(), s, su, sv);
    const gp_Vec r(p, s);
    const double small = 1e-7 * size * size;
    const auto right = [&](double t, double slope) {
        return std::abs(slope) <= small || (t <= 0.0 && slope > 0.0) || (t >= 1.0 && slope < 0.0);
    };
    RC_ASSERT(right(foot.uv.X(), r.Dot(su)));
    RC_ASSERT(right(foot.uv.Y(), r.Dot(sv)));
}
