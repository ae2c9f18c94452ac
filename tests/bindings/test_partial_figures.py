# SPDX-License-Identifier: LGPL-2.1-or-later
"""Masses and common solids of stacks with boundaries, against closed forms and meshes of the finished surfaces."""

from typing import Any, Sequence, Tuple

import FreeCAD
import laminate_offset as lo
import numpy
import Part
import pytest

RAMP = FreeCAD.Units.Quantity("30 mm")
EXACT = 1e-6  # mm: the finished surfaces stand so near to the ideal ones that a ply is measured by


def tape(*plies: Tuple[str, float]) -> lo.Layup:
    """Plies of one material, each with its boundary and thickness."""
    rows = (lo.Ply(f"P{i}", "tape", t, boundary=name) for i, (name, t) in enumerate(plies, 1))
    return lo.Layup(tuple(rows), (lo.Material("tape", density=1600.0),))


def cylinder_panel(radius: float) -> Any:
    """3 radians of a cylinder about z, from z = 0 to 300; its outward normal points away from the axis."""
    surface = Part.Cylinder()
    surface.Radius = radius
    return surface.toShape(0.0, 3.0, 0.0, 300.0)


def wavy_plate() -> Any:
    """400 x 300 as a doubly curved spline."""
    rows = [
        [FreeCAD.Vector(80 * i, 60 * j, 15.0 * numpy.sin(0.9 * i) * numpy.cos(0.8 * j)) for j in range(6)]
        for i in range(6)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape().Faces[0]


def along_lines(face: Any, u0: float, u1: float, v0: float, v1: float) -> Any:
    """A closed wire along parameter lines."""
    surface = face.Surface
    sides = [(surface.vIso(v0), u0, u1), (surface.uIso(u1), v0, v1)]
    sides += [(surface.vIso(v1), u0, u1), (surface.uIso(u0), v0, v1)]
    return Part.Wire([curve.toShape(first, last) for curve, first, last in sides])


def spans(surfaces: Sequence[Any], box: Sequence[float], parts: int) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """The knots of all surfaces inside a box, with each span in equal parts."""
    lines = []
    for along_u, low, high in ((True, *box[:2]), (False, *box[2:])):
        knots = {k for s in surfaces for k in (s.getUKnots() if along_u else s.getVKnots()) if low < k < high}
        ends = numpy.array([low, *sorted(knots), high])
        steps = numpy.arange(parts) / parts
        lines.append(numpy.append((ends[:-1, None] + numpy.diff(ends)[:, None] * steps).ravel(), high))
    return lines[0], lines[1]


def gauss(surface: Any, box: Sequence[float]) -> Tuple[numpy.ndarray, numpy.ndarray]:
    """Parameters (n, 2) and weights of Gauss's rule on every span."""
    nodes, weights = numpy.polynomial.legendre.leggauss(6)
    places, sizes = [], []
    for line in spans([surface], box, 1):
        half = 0.5 * numpy.diff(line)[:, None]
        places.append((line[:-1, None] + half * (1.0 + nodes)).ravel())
        sizes.append((half * weights).ravel())
    return numpy.stack(numpy.meshgrid(*places, indexing="ij"), -1).reshape(-1, 2), numpy.outer(*sizes).ravel()


def points_on(surface: Any, uv: numpy.ndarray) -> numpy.ndarray:
    """Points (n, 3)."""
    return numpy.array([tuple(surface.value(u, v)) for u, v in uv])


@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_a_patch_with_a_ramp_on_a_cylinder(direction: str) -> None:
    radius, sign = 100.0, 1.0 if direction == "normal" else -1.0
    face, base, patch, cover = cylinder_panel(radius), 0.5, 0.4, 0.25
    given = {"patch": along_lines(face, 1.0, 2.0, 100.0, 200.0)}
    layup = tape(("", base), ("patch", patch), ("", cover))
    stack = lo.stack_plies(face, layup, EXACT, direction, boundaries=given, drop_off=RAMP)
    figures = stack.mass_properties()
    # per radian and mm of length between two distances
    ring = lambda low, high: 0.5 * abs((radius + sign * high) ** 2 - (radius + sign * low) ** 2)  # noqa: E731
    assert figures.plies[0].volume == pytest.approx(900.0 * ring(0.0, base), rel=1e-9)
    assert figures.plies[1].volume == pytest.approx(100.0 * ring(base, base + patch), rel=1e-7)
    assert figures.plies[1].area == pytest.approx(100.0 * (radius + sign * (base + 0.5 * patch)), rel=1e-7)
    middle = figures.plies[1].center
    assert middle.z == pytest.approx(150.0, abs=1e-4) and numpy.arctan2(middle.y, middle.x) == pytest.approx(1.5)
    # the volume of the cover is the integral of t (R + d + t/2), with d measured on the finished surface
    surface = stack.plies[2].bottom_face.Surface
    uv, weights = gauss(surface, (0.0, 3.0, 0.0, 300.0))
    points = points_on(surface, uv)
    distance = sign * (numpy.hypot(points[:, 0], points[:, 1]) - radius)
    assert distance.max() == pytest.approx(0.9, abs=1e-5) and distance.min() == pytest.approx(0.5, abs=1e-5)
    volume = (weights * cover * (radius + sign * (distance + 0.5 * cover))).sum()
    assert figures.plies[2].volume == pytest.approx(volume, rel=1e-8)
    low, high = (900.0 * ring(at, at + cover) for at in (base, base + patch))
    assert min(low, high) < figures.plies[2].volume < max(low, high)
    assert figures.mass == pytest.approx(1600e-9 * sum(ply.volume for ply in figures.plies), rel=1e-12)
    assert figures.relative_error < 1e-9 and stack.plies[2].mass == figures.plies[2].mass


def test_a_patch_with_a_ramp_on_a_plane() -> None:
    face = Part.makePlane(400.0, 300.0)
    given = {"patch": along_lines(face, 100.0, 220.0, 90.0, 170.0)}
    layup = tape(("", 0.5), ("patch", 0.4), ("", 0.25))
    stack = lo.stack_plies(face, layup, EXACT, surface="middle", boundaries=given, drop_off=RAMP)
    figures = stack.mass_properties()
    expected = [120000.0 * 0.5, 120.0 * 80.0 * 0.4, 120000.0 * 0.25]  # the ramp only shears the cover
    assert [ply.volume for ply in figures.plies] == pytest.approx(expected, rel=1e-8)
    middle = stack.plies[2].face.Surface
    uv, weights = gauss(middle, (0.0, 400.0, 0.0, 300.0))
    normal_z = numpy.array([abs(middle.normal(u, v).z) for u, v in uv])
    assert figures.plies[2].area == pytest.approx((weights / normal_z).sum(), rel=1e-9)
    assert figures.plies[2].area > 120000.0 * (1.0 + 1e-6)
    heights = points_on(middle, uv)[:, 2] * (1.0 if face.normalAt(0.0, 0.0).z > 0 else -1.0)
    assert figures.plies[2].center.z == pytest.approx((weights * heights).sum() / 120000.0, abs=1e-6)
    assert numpy.hypot(*(figures.plies[1].center - FreeCAD.Vector(160.0, 130.0, 0.0))[:2]) < 1e-5


def mesh_volume(bottom: Any, top: Any, box: Sequence[float], parts: int) -> float:
    """Between two surfaces over a box of parameters, as the volume of a closed polyhedron."""
    us, vs = spans([bottom, top], box, parts)
    uv = numpy.stack(numpy.meshgrid(us, vs, indexing="ij"), -1).reshape(-1, 2)
    origin = points_on(bottom, uv[:1])[0]
    low, high = (points_on(s, uv).reshape(len(us), len(vs), 3) - origin for s in (bottom, top))

    def flux(grid: numpy.ndarray) -> float:
        a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
        return float((numpy.cross(b - a, c - a) * a + numpy.cross(c - a, d - a) * a).sum()) / 6.0

    border = [numpy.s_[:, 0], numpy.s_[-1, :], numpy.s_[::-1, -1], numpy.s_[0, ::-1]]
    sides = sum(flux(numpy.stack([low[at], high[at]], axis=1)) for at in border)
    return abs(flux(high) - flux(low) + sides)


def test_a_cover_over_a_free_form_face_agrees_with_its_mesh() -> None:
    face = wavy_plate()
    u0, u1, v0, v1 = face.ParameterRange
    at = lambda x, y: (u0 + x * (u1 - u0), v0 + y * (v1 - v0))  # noqa: E731
    (a, c), (b, d) = at(0.3, 0.35), at(0.6, 0.7)
    given = {"patch": along_lines(face, a, b, c, d)}
    layup = tape(("", 0.5), ("patch", 0.4), ("", 0.25))
    stack = lo.stack_plies(face, layup, EXACT, boundaries=given, drop_off=RAMP)
    for ply, box in ((stack.plies[2], (u0, u1, v0, v1)), (stack.plies[1], (a, b, c, d))):
        surfaces = (ply.bottom_face.Surface, ply.top_face.Surface)
        coarse, fine = (mesh_volume(*surfaces, box, parts) for parts in (2, 4))
        limit = fine + (fine - coarse) / 3.0  # the error falls with the square of the step
        assert abs(fine - coarse) < 1e-2 * fine
        assert ply.volume == pytest.approx(limit, rel=1e-6)


@pytest.mark.parametrize("shape", ["plane", "cylinder", "cone", "free form"])
def test_solids_below_and_above_ramps(shape: str) -> None:
    cone = Part.Cone()
    cone.SemiAngle, cone.Radius = 0.3, 80.0
    faces = {
        "plane": lambda: Part.makePlane(400.0, 300.0),
        "cylinder": lambda: cylinder_panel(100.0),
        "cone": lambda: cone.toShape(0.0, 3.0, 0.0, 300.0),
        "free form": wavy_plate,
    }
    face = faces[shape]()
    u0, u1, v0, v1 = face.ParameterRange
    middle = face.valueAt(0.5 * (u0 + u1), 0.5 * (v0 + v1))
    normal = face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1))
    given = {
        "round": Part.Wire(Part.makeCircle(30.0, middle, normal)),
        "square": along_lines(face, *(0.4 * u0 + 0.6 * u1, 0.2 * u0 + 0.8 * u1), *(0.6 * v0 + 0.4 * v1, v1 * 0.8)),
        "end": lo.Boundary(face.Surface.vIso(0.3 * v0 + 0.7 * v1).toShape(u0, u1), side="right"),
    }
    layup = tape(("", 0.25), ("round", 0.4), ("square", 0.3), ("", 0.25), ("end", 0.3), ("end", 0.3), ("", 0.25))
    stack = lo.stack_plies(face, layup, boundaries=given, drop_off=RAMP, solids=True)
    for ply in stack.plies:
        assert ply.solid.isValid() and ply.solid.isClosed() and ply.solid.ShapeType == "Solid", ply.ply.name
        assert ply.solid.Volume == pytest.approx(ply.volume, rel=2e-3), ply.ply.name
        assert max(edge.Tolerance for edge in ply.solid.Edges) <= 1e-3, ply.ply.name
    runs = stack.material_solids()
    assert [[ply.ply.number for ply in run.plies] for run in runs] == [[1], [2], [3], [4], [5, 6], [7]]
    for run in runs:
        assert run.solid.isValid() and run.solid.isClosed()
        assert run.solid.Volume == pytest.approx(sum(ply.volume for ply in run.plies), rel=2e-3)
    whole = stack.laminate_solid()
    assert whole.isValid() and whole.isClosed()
    # with the pockets beside the plies that end below others
    assert whole.Volume > (1.0 + 1e-3) * stack.mass_properties().volume


@pytest.mark.parametrize("shape", ["plane", "free form"])
@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_a_laminate_that_begins_and_ends_with_parts_is_one_solid(shape: str, direction: str) -> None:
    face = Part.makePlane(400.0, 300.0) if shape == "plane" else wavy_plate()
    u0, u1, v0, v1 = face.ParameterRange
    at = lambda a, b, c, d: (
        u0 + a * (u1 - u0),
        u0 + b * (u1 - u0),
        v0 + c * (v1 - v0),
        v0 + d * (v1 - v0),
    )  # noqa: E731
    given = {
        "below": along_lines(face, *at(0.2, 0.5, 0.2, 0.6)),
        "above": along_lines(face, *at(0.4, 0.8, 0.3, 0.8)),
        "end": lo.Boundary(face.Surface.vIso(v0 + 0.5 * (v1 - v0)).toShape(u0, u1), side="right"),
    }
    upwards = tape(("", 0.25), ("above", 0.3), ("above", 0.3))
    stack = lo.stack_plies(
        face, upwards, direction=direction, boundaries=given, drop_off=RAMP, stagger={"above": [0, 10]}
    )
    body = stack.laminate_solid()
    assert body.isValid() and body.isClosed() and body.ShapeType == "Solid"
    assert body.Volume == pytest.approx(stack.mass_properties().volume, rel=1e-4)
    both = lo.stack_plies(
        face, tape(("below", 0.3), ("", 0.25), ("end", 0.3)), direction=direction, boundaries=given, drop_off=RAMP
    )
    body = both.laminate_solid()
    assert body.isValid() and body.isClosed() and body.ShapeType == "Solid"
    assert body.Volume == pytest.approx(both.mass_properties().volume, rel=2e-3)
    places = [(u0 + 0.45 * (u1 - u0), v0 + part * (v1 - v0)) for part in (0.45, 0.55)]
    seen = set()
    for ply in both.plies:
        for u, v in places:
            middle = (ply.bottom_face.Surface.value(u, v) + ply.top_face.Surface.value(u, v)) * 0.5
            there = ply.base_face.isPartOfDomain(u, v)
            assert body.isInside(middle, 1e-6, False) == there, ply.ply.name
            seen.add((ply.ply.number, there))
    assert seen == {(1, True), (2, True), (3, True), (3, False)}


def test_a_laminate_of_parts_alone() -> None:
    face = wavy_plate()
    given = {"patch": Part.Wire(Part.makeCircle(40.0, FreeCAD.Vector(200.0, 150.0, 0.0)))}
    given["other"] = Part.Wire(Part.makeCircle(40.0, FreeCAD.Vector(220.0, 150.0, 0.0)))
    apart = lo.stack_plies(face, tape(("patch", 0.25), ("other", 0.25)), boundaries=given, drop_off=RAMP)
    with pytest.raises(ValueError, match="No ply covers the whole face.*material_solids"):
        apart.laminate_solid()
    alone = lo.stack_plies(face, tape(("patch", 0.25), ("patch", 0.25)), boundaries=given)
    assert alone.plies[0].base_face is alone.plies[1].base_face
    assert alone.laminate_solid().isValid()
    assert alone.laminate_solid().Volume == pytest.approx(alone.mass_properties().volume, rel=1e-3)


def test_figures_do_not_depend_on_where_and_how_the_face_stands() -> None:
    face, turn = wavy_plate(), FreeCAD.Placement(FreeCAD.Vector(900, -200, 70), FreeCAD.Rotation(40, 50, 60))
    u0, u1, v0, v1 = face.ParameterRange
    at = (u0 + 0.3 * (u1 - u0), u0 + 0.6 * (u1 - u0), v0 + 0.3 * (v1 - v0), v0 + 0.7 * (v1 - v0))
    wire, layup = along_lines(face, *at), tape(("", 0.5), ("patch", 0.4), ("", 0.25))
    plain = lo.stack_plies(face, layup, boundaries={"patch": wire}, drop_off=RAMP).mass_properties()
    moved, moved_wire = face.copy(), wire.copy()
    moved.Placement, moved_wire.Placement = turn, turn
    for reversed_face in (False, True):
        stack = lo.stack_plies(
            moved.reversed() if reversed_face else moved,
            layup,
            direction="reversed" if reversed_face else "normal",
            boundaries={"patch": moved_wire},
            drop_off=RAMP,
        )
        for ply, expected in zip(stack.mass_properties().plies, plain.plies):
            assert ply.volume == pytest.approx(expected.volume, rel=1e-9)
            assert ply.area == pytest.approx(expected.area, rel=1e-9)
            assert (ply.center - turn.multVec(expected.center)).Length < 1e-6
