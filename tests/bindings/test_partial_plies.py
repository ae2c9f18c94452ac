# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plies with boundaries: the parts that they cover, the plies above that come down over ramps, and what is refused."""

import json
from pathlib import Path

import FreeCAD
import numpy
import Part
import pytest

import laminate_offset as lo
import sample_shapes
from laminate_offset import boundaries, boundary_texts, cli, files, partial_stack

RAMP = FreeCAD.Units.Quantity("60 mm")


def layup(*boundaries: str, thickness: float = 0.5) -> lo.Layup:
    """One ply a name; "" covers the whole face."""
    return lo.Layup(tuple(lo.Ply(f"P{i}", "tape", thickness, boundary=name) for i, name in enumerate(boundaries, 1)))


def plate() -> "Part.Face":
    """400 x 300, slightly bent, as a spline."""
    rows = [[FreeCAD.Vector(80 * i - 200, 60 * j - 150, 0.4 * i * i + 0.3 * i * j) for j in range(6)] for i in range(6)]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape().Faces[0]


def disc(x: float, y: float, radius: float) -> "Part.Wire":
    return Part.Wire([Part.makeCircle(radius, FreeCAD.Vector(x, y, 5))])


def height(face: "Part.Face", above: "Part.Face", u: float, v: float) -> float:
    return float((above.Surface.value(u, v) - face.Surface.value(u, v)).dot(face.normalAt(u, v)))


@pytest.mark.parametrize("stagger", [None, [3.0]])
def test_a_creased_face_is_refused_for_its_crease_and_the_remedy_works(stagger: object) -> None:
    roof = sample_shapes.roof_face(100.0, 200.0)
    patch = Part.Wire([Part.makeCircle(20.0, FreeCAD.Vector(100, 60, -60), FreeCAD.Vector(0, 1, 1))])
    arguments = {"boundaries": {"patch": patch}, "drop_off": RAMP, "stagger": stagger}
    with pytest.raises(
        lo.OffsetError, match="split the face along the crease .*Slice apart.* each of its parts"
    ) as refused:
        lo.stack_plies(roof, layup("", "patch", ""), **arguments)
    assert (refused.value.status, refused.value.stage) == ("not-supported", "analysis")
    assert refused.value.where["y"] == pytest.approx(0.0, abs=1e-6)
    # what Slice apart does, with a plane or with a line through the ridge
    for tool in (
        Part.makePlane(400.0, 400.0, FreeCAD.Vector(-100, 0, -200), FreeCAD.Vector(0, 1, 0), FreeCAD.Vector(0, 0, 1)),
        Part.makeLine(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(200, 0, 0)),
    ):
        pieces = roof.generalFuse([tool])[1][0]
        assert len(pieces) == 2
        (side,) = (piece for piece in pieces if piece.CenterOfMass.y > 0)
        assert [ply.face.isValid() for ply in lo.stack_plies(side, layup("", "patch", ""), **arguments).plies] == [
            True
        ] * 3


def test_the_ply_above_comes_down_beside_the_patch() -> None:
    face = plate()
    stack = lo.stack_plies(face, layup("", "patch", ""), boundaries={"patch": disc(0, 0, 60)}, drop_off=RAMP)
    bottom, patch, top = stack.plies
    assert stack.report["partial_plies"] == 1 and stack.report["certified_error"] <= 1e-3
    assert patch.base_face.Area == pytest.approx(numpy.pi * 60**2, rel=0.05)
    assert top.over_ramp and not bottom.over_ramp
    assert all(ply.face.isValid() for ply in stack.plies)
    u0, u1, v0, v1 = face.ParameterRange
    middle, corner = (0.5 * (u0 + u1), 0.5 * (v0 + v1)), (u0 + 0.05 * (u1 - u0), v0 + 0.05 * (v1 - v0))
    assert height(face, top.bottom_face, *middle) == pytest.approx(1.0, abs=2e-3)
    assert height(face, top.bottom_face, *corner) == pytest.approx(0.5, abs=2e-3)
    assert height(face, top.top_face, *corner) == pytest.approx(1.0, abs=2e-3)
    for ply in stack.plies:
        assert ply.solid.isValid() and ply.solid.Volume == pytest.approx(0.5 * ply.base_face.Area, rel=0.01)
    assert 0.0 < stack.report["boundary_gaps"]["patch"] < 15.0
    low, high = top.levels([middle, corner])
    assert low == pytest.approx([1.0, 0.5], abs=2e-3) and high == pytest.approx([1.5, 1.0], abs=2e-3)
    assert stack.thickness([middle, corner]) == pytest.approx([1.5, 1.0], abs=2e-3)
    assert len(stack.core_sample(tuple(face.valueAt(*corner))).layers) == 2
    ends = [face.valueAt(u, v) for u in (u0, u1) for v in (v0, v1)]
    assert [len(stack.core_sample(end).layers) for end in ends] == [2] * 4
    outside = [face.valueAt(*corner) + FreeCAD.Vector(-900, 0, 0), face.valueAt(*corner) + FreeCAD.Vector(0, -900, 0)]
    assert stack.thickness([tuple(point) for point in outside]).tolist() == [0.0, 0.0]
    entry = stack.ply_reports()[1]
    assert entry["boundary"] == "patch" and entry["report"]["certified_error"] <= 1e-3


def test_shapes_that_bound_plies() -> None:
    face = plate()
    whole = face.Area
    ring = Part.Compound([disc(0, 0, 90), disc(0, 0, 40)])
    line = Part.makeLine(FreeCAD.Vector(0, -200, 5), FreeCAD.Vector(0, 200, 5))
    sketch = FreeCAD.newDocument("Boundaries").addObject("Part::Feature", "Sketch")
    try:
        sketch.Shape = disc(0, 0, 60)
        given = {
            "wire": disc(0, 0, 60),
            "edges": disc(0, 0, 60).Edges,
            "face": Part.Face(disc(0, 0, 60)),
            "object": sketch,
            "ring": ring,
            "outside": lo.Boundary(disc(0, 0, 60), side="outside"),
            "left": lo.Boundary(line, side="left"),
            "right": lo.Boundary(line, side="right"),
            "point": lo.Boundary(line, point=(-150, 0, 0)),
        }
        stack = lo.stack_plies(face, layup(*given), boundaries=given, surface="middle", drop_off=RAMP)
    finally:
        FreeCAD.closeDocument("Boundaries")
    area = {ply.ply.ply.boundary: ply.base_face.Area for ply in stack.plies}
    for name in ("edges", "face", "object"):
        assert area[name] == pytest.approx(area["wire"], rel=1e-6)
    assert area["outside"] + area["wire"] == pytest.approx(whole, rel=1e-4)
    assert area["left"] + area["right"] == pytest.approx(whole, rel=1e-4)
    assert area["point"] == pytest.approx(area["left"], rel=1e-6)
    assert area["ring"] == pytest.approx(numpy.pi * (90**2 - 40**2), rel=0.05)
    assert all(ply.face.isValid() for ply in stack.plies)


@pytest.mark.parametrize("half_width", [0.5, 20.0, 80.0, 400.0])
@pytest.mark.parametrize("flat", [True, False])
def test_a_line_may_go_past_the_edges(flat: bool, half_width: float) -> None:
    face = Part.makePlane(400, 300, FreeCAD.Vector(-200, -150, 0)) if flat else plate()
    line = Part.makeLine(FreeCAD.Vector(5 - half_width, -300, 2), FreeCAD.Vector(5 + half_width, 300, 2))
    areas = []
    for side in ("left", "right"):
        stack = lo.stack_plies(
            face,
            layup("", "half", ""),
            boundaries={"half": lo.Boundary(line, side=side)},
            drop_off=RAMP,
            boundary_gap=60.0,
        )
        areas.append(stack.plies[1].base_face.Area)
        assert stack.plies[1].solid.isValid()
    assert sum(areas) == pytest.approx(face.Area, rel=1e-4)
    if flat and half_width < 100:
        assert min(areas) == pytest.approx(300 * 195, rel=1e-6)


def test_wrong_boundaries_are_named() -> None:
    face = plate()
    with pytest.raises(lo.LayupError, match="ply 2, boundary: found 'flap', expected one of patch"):
        lo.stack_plies(face, layup("", "flap"), boundaries={"patch": disc(0, 0, 60)})
    with pytest.raises(TypeError, match="'patch'"):
        lo.stack_plies(face, layup("patch"), boundaries={"patch": "a text"})
    with pytest.raises(ValueError, match="side must be one of"):
        lo.Boundary(disc(0, 0, 60), side="above")
    line = Part.makeLine(FreeCAD.Vector(0, -200, 5), FreeCAD.Vector(0, 200, 5))
    with pytest.raises((lo.OffsetError, ValueError), match="'patch'.*open"):
        lo.stack_plies(face, layup("patch"), boundaries={"patch": line})
    with pytest.raises(lo.OffsetError, match="A ramp of 0.5 mm beside the boundary 'patch'.*longer"):
        lo.stack_plies(face, layup("", "patch", "", thickness=0.025), boundaries={"patch": disc(0, 0, 60)}, drop_off=20)
    with pytest.raises((lo.OffsetError, ValueError), match="ratio"):
        lo.stack_plies(face, layup("patch"), boundaries={"patch": disc(0, 0, 60)}, drop_off=0.1)


def test_a_boundary_far_from_the_face_is_refused_with_its_distance() -> None:
    face = Part.makePlane(400.0, 300.0, FreeCAD.Vector(-200, -150, 0))
    far = Part.Wire([Part.makeCircle(60.0, FreeCAD.Vector(0, 0, 80))])
    two = layup("", "patch")
    with pytest.raises(lo.OffsetError, match="'patch': It stands 80 mm from the face.*boundary gap of") as refused:
        lo.stack_plies(face, two, boundaries={"patch": far})
    assert numpy.hypot(refused.value.where["x"], refused.value.where["y"]) == pytest.approx(60.0, abs=1e-2)
    for allowed in (81, FreeCAD.Units.Quantity("81 mm")):
        stack = lo.stack_plies(face, two, boundaries={"patch": far, "unused": far}, boundary_gap=allowed)
        assert list(stack.report["boundary_gaps"]) == ["patch"]
        assert stack.report["boundary_gaps"]["patch"] == pytest.approx(80.0, abs=1e-2)
    for wrong, error in (("80", TypeError), (True, TypeError), (-1.0, ValueError), (float("nan"), ValueError)):
        with pytest.raises(error, match="boundary_gap must be a distance"):
            lo.stack_plies(face, two, boundaries={"patch": far}, boundary_gap=wrong)


@pytest.mark.parametrize("middle", [0.0, 0.35, 2.0])
def test_a_patch_may_lie_across_the_seam_of_a_tube(middle: float) -> None:
    tube = Part.makeCylinder(100.0, 300.0).Faces[0]
    a, b = middle - 0.3, middle + 0.3
    at = lambda angle, z: FreeCAD.Vector(100 * numpy.cos(angle), 100 * numpy.sin(angle), z)  # noqa: E731
    circles = [Part.Circle(FreeCAD.Vector(0, 0, z), FreeCAD.Vector(0, 0, 1), 100) for z in (100, 200)]
    arcs = [Part.ArcOfCircle(circle, a, b) for circle in circles]
    sides = [Part.makeLine(at(angle, 100), at(angle, 200)) for angle in (a, b)]
    wire = Part.Wire(Part.sortEdges([arc.toShape() for arc in arcs] + sides)[0])
    stack = lo.stack_plies(tube, layup("", "patch", ""), boundaries={"patch": wire}, drop_off=RAMP)
    assert stack.report["seam_moved"] == (middle < 1.0) and stack.base_face.isValid()
    assert stack.plies[1].volume == pytest.approx(0.6 * 100 * (101.0**2 - 100.5**2) / 2, rel=1e-5)
    angles = [a + 0.01, middle, b - 0.01, b + 0.8, a - 0.8]
    points = [tuple(at(angle, 150)) for angle in angles]
    assert stack.thickness(points) == pytest.approx([1.5, 1.5, 1.5, 1.0, 1.0], abs=2e-3)
    assert [len(stack.core_sample(point).layers) for point in points] == [3, 3, 3, 2, 2]
    assert all(ply.solid.isValid() for ply in stack.plies) and stack.laminate_solid().isValid()


@pytest.mark.parametrize("towards", [(1, 0, 0), (-1, 0, 0), (0.6, -0.64, 0.48), (0.8, 0.0, 0.6)])
@pytest.mark.parametrize("kind", ["sphere", "moved", "mirrored", "spline"])
def test_a_patch_on_a_whole_sphere(towards: tuple, kind: str) -> None:
    if kind == "spline" and towards != (1, 0, 0):
        pytest.skip("takes a minute; one direction stands for all on splines")
    radius = 100.0
    sphere = Part.makeSphere(radius).Faces[0]
    if kind == "moved":
        sphere.Placement = FreeCAD.Placement(FreeCAD.Vector(10, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 50))
    elif kind == "mirrored":
        sphere = sphere.mirror(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0)).Faces[0]
    elif kind == "spline":
        sphere = sphere.toNurbs().Faces[0]
    place = sphere.Placement if kind == "moved" else FreeCAD.Placement()
    axis = place.Rotation.multVec(FreeCAD.Vector(*towards))
    across = 0.2  # radians from the axis to the circle
    circle = Part.makeCircle(radius * numpy.sin(across), place.Base + axis * (radius * numpy.cos(across)), axis)
    stack = lo.stack_plies(sphere, layup("", "patch", ""), boundaries={"patch": Part.Wire([circle])}, drop_off=40)
    assert stack.report["certified_error"] <= 1e-3
    # a mirrored sphere's outward normal points to its middle
    sign = 1.0 if sphere.normalAt(1.0, 0.5) * (sphere.valueAt(1.0, 0.5) - place.Base) > 0.0 else -1.0
    assert sign > 0.0 or kind == "mirrored"
    cap = (1.0 - numpy.cos(across)) / 2.0 * 4.0 / 3.0 * numpy.pi * abs((100.0 + sign) ** 3 - (100.0 + 0.5 * sign) ** 3)
    assert stack.plies[1].volume == pytest.approx(cap, rel=1e-5)
    assert all(ply.solid.isValid() and ply.face.isValid() for ply in stack.plies)
    rng = numpy.random.default_rng(5)
    points = rng.normal(size=(200, 3))
    points = points / numpy.linalg.norm(points, axis=1)[:, None]
    points = numpy.concatenate([points, [(0, 0, 1), (0, 0, -1), tuple(place.Rotation.inverted().multVec(axis))]])
    points = numpy.array([tuple(place.multVec(FreeCAD.Vector(*(radius * point)))) for point in points])
    angles = numpy.arccos(numpy.clip((points - tuple(place.Base)) @ tuple(axis) / radius, -1.0, 1.0))
    thickness = stack.thickness(points)
    assert numpy.abs(thickness[angles < across - 0.01] - 1.5).max() < 2e-3 and (angles < across - 0.01).any()
    assert numpy.abs(thickness[angles > across + 0.01] - 1.0).max() < 2e-3
    # by FreeCAD alone: the uppermost surface is three plies high over the patch, two past the ramp, and between on the ramp
    top = stack.plies[2].top_face
    u0, u1, v0, v1 = top.ParameterRange
    grid = [top.valueAt(u, v) - place.Base for u in numpy.linspace(u0, u1, 41) for v in numpy.linspace(v0, v1, 41)]
    away = numpy.array([point.getAngle(axis) for point in grid])
    heights = sign * (numpy.array([point.Length for point in grid]) - radius)
    assert (
        numpy.abs(heights[away < across] - 1.5).max() < 2e-3
        and numpy.abs(heights[away > across + 0.22] - 1.0).max() < 2e-3
    )
    assert (away < across).sum() > 3 and heights.min() > 1.0 - 2e-3 and heights.max() < 1.5 + 2e-3


def test_ramps_reach_no_pole_of_a_sphere() -> None:
    sphere = Part.makeSphere(100.0).Faces[0]
    for towards in ((0.3, 0, 0.95), (-0.3, 0, 0.95), (0, 0.3, -0.95)):
        axis = FreeCAD.Vector(*towards).normalize()
        given = {"patch": Part.Wire([Part.makeCircle(20.0, axis * 98.0, axis)])}
        with pytest.raises(lo.OffsetError, match="'patch' reaches the seam of the closed face, or a point"):
            lo.stack_plies(sphere, layup("", "patch", ""), boundaries=given, drop_off=40)
    cone = Part.makeCone(50, 0, 100).Faces[0]
    given = {"patch": Part.Wire([Part.makeCircle(8, FreeCAD.Vector(-30, 0, 40), FreeCAD.Vector(1, 0, 0))])}
    with pytest.raises(lo.OffsetError, match="ends in a point.*cut the tip off the face") as refused:
        lo.stack_plies(cone, layup("", "patch", ""), boundaries=given, drop_off=20)
    assert refused.value.status == "not-supported" and refused.value.where["z"] == pytest.approx(100.0)


def test_ramps_are_reported_and_their_steepest_slope_can_be_given() -> None:
    face = Part.makePlane(400.0, 300.0, FreeCAD.Vector(-200, -150, 0))
    line = Part.makeLine(FreeCAD.Vector(0, -200, 0), FreeCAD.Vector(0, 200, 0))
    given = {"half": lo.Boundary(line, side="left")}
    mean, steepest = (
        lo.stack_plies(face, layup("", "half", ""), boundaries=given, drop_off=40, ramp_slope=kind)
        for kind in ("mean", "steepest")
    )
    assert mean.plies[0].ramp is None and mean.plies[2].ramp is None
    ramp = mean.ply_reports()[1]["ramp"]
    assert ramp["length"] == 20.0 and ramp["mean_slope"] == 1 / 40 and ramp["start_slope"] == ramp["end_slope"] == 0.0
    assert 1.3 / 40 < ramp["steepest_slope"] < 1.9 / 40
    longer = steepest.plies[1].ramp
    assert 0.9 / 40 < longer["steepest_slope"] <= 1 / 40 and longer["length"] > 1.3 * 20.0
    with pytest.raises(ValueError, match="ramp_slope must be one of mean, steepest"):
        lo.stack_plies(face, layup("half"), boundaries=given, ramp_slope="flat")


def test_ramps_that_add_up_are_warned_of(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    face = Part.makePlane(400.0, 300.0, FreeCAD.Vector(-200, -150, 0))
    line = Part.makeLine(FreeCAD.Vector(30, -200, 0), FreeCAD.Vector(30, 200, 0))
    given = {"half": lo.Boundary(line, side="left")}
    plies = layup("", "half", "half", "half", "")
    together = lo.stack_plies(face, plies, boundaries=given)
    (warning,) = together.report["warnings"]
    (steep,) = together.report["steep_ramps"]
    one = together.plies[1].ramp["steepest_slope"]
    assert steep["slope"] == pytest.approx(3 * one, rel=0.02) and steep["alone"] == pytest.approx(one, rel=1e-9)
    assert steep["plies"] == ["P2", "P3", "P4"] and steep["boundaries"] == ["half"] and steep["longest"] == 10.0
    assert 30.0 < steep["where"]["x"] < 40.0 and steep["where"]["z"] == 0.0
    assert (
        warning.startswith("Plies P2, P3 and P4 end along one line")
        and "stagger (0, 10, ...) of the boundary 'half'." in warning
    )
    assert f"1:{1 / steep['slope']:.3g}, 3 times as steeply" in warning and f"({steep['where']['x']:.6g}, " in warning
    assert json.loads(together.to_json())["warnings"] == [warning]
    staggered = lo.stack_plies(face, plies, boundaries=given, stagger=[0, 10, 20])
    assert staggered.report["warnings"] == [] and staggered.report["steep_ramps"] == []
    assert lo.stack_plies(face, layup("", "")).report["warnings"] == []
    source, outlines, table = tmp_path / "base.brep", tmp_path / "outlines.brep", tmp_path / "layup.csv"
    files.write_shape(face, str(source), "base")
    files.write_shape(Part.Wire([line]), str(outlines), "outlines")
    rows = "".join(f"P{i},tape,0.5,0,{name}\n" for i, name in enumerate(["", "1", "1", ""], 1))
    table.write_text("ply,material,thickness_mm,angle_deg,boundary\n" + rows, encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.brep")]
    arguments += ["--boundaries", str(outlines), "--side", "1=left"]
    for stagger, warned in ((["--stagger", "1=0,10"], False), ([], True)):
        assert cli.main(arguments + stagger) == 0
        assert ("warning: Plies P2 and P3 end along one line" in capfd.readouterr().err) == warned


def test_every_set_of_boundaries_is_warned_of_once() -> None:
    face = Part.makePlane(400.0, 300.0, FreeCAD.Vector(-200, -150, 0))
    at = [Part.makeLine(FreeCAD.Vector(x, -200, 0), FreeCAD.Vector(x, 200, 0)) for x in (-120.0, 30.0, 34.0, 150.0)]
    given = {name: lo.Boundary(line, side="left") for name, line in zip(("a", "b", "c", "d"), at)}
    # two plies end at "a", "b" and "c" lie 4 mm apart, and "d" is by itself
    stack = lo.stack_plies(face, layup("", "a", "a", "b", "c", "d", ""), boundaries=given)
    places = {tuple(place["boundaries"]): place for place in stack.report["steep_ramps"]}
    assert set(places) == {("a",), ("b", "c")} and len(stack.report["warnings"]) == 2
    assert places["a",]["plies"] == ["P2", "P3"] and -120.0 < places["a",]["where"]["x"] < -110.0
    assert places["b", "c"]["plies"] == ["P4", "P5"] and 30.0 < places["b", "c"]["where"]["x"] < 44.0
    (pair,) = [text for text in stack.report["warnings"] if "P4" in text]
    assert pair.startswith("Plies P4 and P5 end near each other: near (")
    assert pair.endswith("Keep the boundaries 'b' and 'c' 10 mm apart.")
    ratios = [place["slope"] / place["alone"] for place in stack.report["steep_ramps"]]
    assert ratios == sorted(ratios, reverse=True) and ratios[0] == pytest.approx(2.0, rel=0.02)


def test_figures_of_warnings_are_plain() -> None:
    plain = [
        (1234567.0, "1234567"),
        (0.5, "0.5"),
        (1e-9, "0"),
        (-12.3456, "-12.3"),
        (1000.0, "1000"),
        (0.01234, "0.0123"),
    ]
    assert [partial_stack.plain(value) for value, _ in plain] == [text for _, text in plain]
    up = [
        (10.0, "10"),
        (10.01, "11"),
        (1234.0, "1300"),
        (0.12301, "0.13"),
        (0.000512, "0.00052"),
        (9.99, "10"),
        (2.5, "2.5"),
        (99.5, "100"),
    ]
    assert [partial_stack.plain_up(value) for value, _ in up] == [text for _, text in up]


@pytest.mark.parametrize("point", [(0, float("nan"), 0), "abc", "123", (1, 2), (1, 2, "x"), 5, (0, 0, float("inf"))])
def test_the_point_of_a_boundary_is_three_numbers(point: object) -> None:
    with pytest.raises(ValueError, match="point must be three finite numbers"):
        lo.Boundary(disc(0, 0, 60), point=point)
    assert lo.Boundary(disc(0, 0, 60), point=FreeCAD.Vector(1, 2, 3)).point == (1.0, 2.0, 3.0)


@pytest.mark.parametrize("names", [("", ""), ("patch", "")])
def test_wrong_ramps_and_staggers_are_named_with_and_without_boundaries(names: tuple) -> None:
    face = sample_shapes.bspline_face()
    given = {"patch": disc(0, 0, 60)}
    for wrong in (True, "20 mm", None, [20]):
        with pytest.raises(TypeError, match="drop_off must be a multiple"):
            lo.stack_plies(face, layup(*names), boundaries=given, drop_off=wrong)
    for wrong in (FreeCAD.Units.Quantity("10 kg"), float("nan"), 0.0, FreeCAD.Units.Quantity("-5 mm")):
        with pytest.raises(ValueError, match="drop_off must be a multiple"):
            lo.stack_plies(face, layup(*names), boundaries=given, drop_off=wrong)
    for wrong in (5, "0,5", [True], ["5"], {"patch": 5}, [None]):
        with pytest.raises(TypeError, match="stagger must be a list"):
            lo.stack_plies(face, layup(*names), boundaries=given, stagger=wrong)
    for wrong in ([-1.0], {"patch": [float("nan")]}):
        with pytest.raises(ValueError, match="stagger must be a list"):
            lo.stack_plies(face, layup(*names), boundaries=given, stagger=wrong)
    with pytest.raises(ValueError, match="stagger must be a length"):
        lo.stack_plies(face, layup(*names), boundaries=given, stagger=[FreeCAD.Units.Quantity("1 kg")])
    with pytest.raises(ValueError, match="'flap', which no ply has"):
        lo.stack_plies(face, layup(*names), boundaries=given, stagger={"flap": [1.0]})
    with pytest.raises(TypeError, match="boundaries must be a mapping"):
        lo.stack_plies(face, layup(*names), boundaries=[disc(0, 0, 60)])


def test_a_layup_without_boundaries_goes_the_usual_way() -> None:
    face = sample_shapes.bspline_face()
    plain = lo.stack_plies(face, layup("", ""))
    given = lo.stack_plies(face, layup("", ""), boundaries={"unused": disc(0, 0, 60)})
    assert plain.report["one_fit"] and given.report["one_fit"]
    assert given.report["partial_plies"] == 0
    assert plain.plies[0].base_face.isSame(face) and not plain.plies[0].over_ramp


def test_successive_plies_keep_inside_of_their_boundary() -> None:
    face = plate()
    given = {"patch": disc(0, 0, 90), "other": disc(0, 0, 70)}
    stack = lo.stack_plies(
        face,
        layup("patch", "patch", "other", "patch", ""),
        boundaries=given,
        stagger={"patch": [0, 10, 25]},
        drop_off=RAMP,
    )
    radii = [numpy.sqrt(ply.base_face.Area / numpy.pi) for ply in stack.plies[:4]]
    assert radii == pytest.approx([90, 80, 70, 65], rel=0.02)
    assert 0.0 < stack.report["inset_error"] <= 1e-3
    lengths = [FreeCAD.Units.Quantity("1 cm"), 0]
    moved = lo.stack_plies(face, layup("patch", "patch"), boundaries=given, stagger=lengths, drop_off=RAMP)
    assert moved.plies[0].base_face.Area == pytest.approx(stack.plies[1].base_face.Area, rel=1e-6)
    with pytest.raises(ValueError, match="2 distances for boundary 'patch', which has 3 plies"):
        lo.stack_plies(face, layup("patch", "patch", "patch"), boundaries=given, stagger=[0, 5])
    with pytest.raises(ValueError, match="'flap', which no ply has"):
        lo.stack_plies(face, layup("patch"), boundaries=given, stagger={"flap": [1]})
    with pytest.raises(lo.OffsetError, match="'patch'.*smaller distance"):
        lo.stack_plies(face, layup("patch"), boundaries=given, stagger=[95])


def test_a_table_of_distances_has_one_for_every_ply() -> None:
    rows = layup("pad", "pad", "rim").physical_plies()
    assert boundaries.insets(rows, {"pad": [0.0, 5.0]}) == [0.0, 5.0, 0.0]
    assert boundaries.insets(rows, [0.0, 5.0]) == [0.0, 5.0, 0.0]
    for wrong in ({"pad": [0.0]}, {"pad": [0.0, 2.0, 5.0]}, {"rim": [0.0, 1.0]}, [0.0, 2.0, 5.0], [0.0]):
        with pytest.raises(ValueError, match="distances for boundary.*one for each"):
            boundaries.insets(rows, wrong)
    assert boundary_texts.once([("a", 1), ("b", 2)], "stagger") == {"a": 1, "b": 2}
    with pytest.raises(ValueError, match="--stagger: the boundary 'a' is given twice"):
        boundary_texts.once([("a", 1), ("a", 2)], "--stagger")


@pytest.mark.parametrize("ending", ["FCStd", "step", "brep"])
def test_the_command_takes_boundaries_from_a_file(
    ending: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    face, source, outlines = plate(), tmp_path / "base.brep", tmp_path / f"outlines.{ending}"
    files.write_shape(face, str(source), "base")
    line = Part.makeLine(FreeCAD.Vector(0, -200, 5), FreeCAD.Vector(0, 200, 5))
    names = ["patch", "tip"]
    if ending == "FCStd":
        document = FreeCAD.newDocument("Outlines")
        for name, shape in zip(names, [disc(-50, 0, 60), line]):
            document.addObject("Part::Feature", name.capitalize()).Shape = shape
            document.Objects[-1].Label = name
        document.saveAs(str(outlines))
        FreeCAD.closeDocument(document.Name)
    else:
        names = ["1", "2"]
        files.write_shape(Part.Compound([disc(-50, 0, 60), Part.Wire([line])]), str(outlines), "outlines")
    table, output, report = tmp_path / "layup.csv", tmp_path / "plies.brep", tmp_path / "plies.json"
    rows = [("P1", names[0]), ("P2", names[1]), ("P3", names[1]), ("P4", "")]
    lines = "".join(f"{ply},tape,0.5,0,{boundary}\n" for ply, boundary in rows)
    table.write_text("ply,material,thickness_mm,angle_deg,boundary\n" + lines, encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(output), "--report", str(report)]
    ramps = ["--drop-off", "60mm"]
    asked = ["--boundaries", str(outlines), "--side", f"{names[1]}=left", "--stagger", f"{names[1]}=0,20"]
    asked += ["--boundary-gap", "20", "--ramp-slope", "steepest"]
    assert cli.main(arguments + ramps + asked) == 0, capfd.readouterr().err
    values = json.loads(report.read_text(encoding="utf-8"))
    assert values["partial_plies"] == 3 and len(files.read_faces(str(output))) == 4
    capfd.readouterr()
    assert cli.main(arguments + ramps) == 2
    assert "boundary" in capfd.readouterr().err
    assert cli.main(arguments + asked + ["--side", "flap=left"]) == 2
    assert "flap" in capfd.readouterr().err
    assert cli.main(arguments + ramps + asked + ["--boundary-gap", "0.001"]) == 1
    assert "stands" in capfd.readouterr().err
    output.unlink()
    assert cli.main(arguments + ramps + asked + ["--calculix", str(tmp_path / "section.inp")]) == 2
    said = capfd.readouterr().err
    assert "P1, P2, P3 cover parts of the face only" in said and "wrote" not in said and not output.exists()


@pytest.mark.parametrize("middle", [(50.0, 30.0), (37.3, 28.1)])
@pytest.mark.parametrize("turn", [0.0, 90.0, 180.0, 211.0])
def test_no_ridge_beside_a_patch_whose_curve_ends_where_a_sample_lies(middle, turn) -> None:
    """The image of a circle ends where it began but for rounding, and knots stand beside its extremes at equal distances, so
    that a line of samples runs right through that end."""
    face = Part.makePlane(100, 60)
    x, y = middle
    circle = Part.makeCircle(10, FreeCAD.Vector(x, y, 0))
    circle.rotate(FreeCAD.Vector(x, y, 0), FreeCAD.Vector(0, 0, 1), turn)
    stack = lo.stack_plies(face, layup("", "patch", "", thickness=0.2), boundaries={"patch": Part.Wire([circle])})
    across = numpy.concatenate([numpy.linspace(0, 100, 201)[:, None], numpy.full((201, 1), y)], axis=1)
    along = numpy.concatenate([numpy.full((121, 1), x), numpy.linspace(0, 60, 121)[:, None]], axis=1)
    places = numpy.concatenate([across, along])
    away = numpy.hypot(*(places - middle).T)
    low = stack.plies[2].heights(places)[0]
    assert (away > 16).sum() > 150 and low[away > 16] == pytest.approx(0.2, abs=2e-3)
    assert (away < 9).sum() > 50 and low[away < 9] == pytest.approx(0.4, abs=2e-3)
