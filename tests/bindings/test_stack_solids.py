# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids, figures, fibre directions and core samples of lo.stack_plies."""

import json
import math
from pathlib import Path

import FreeCAD
import laminate_offset as lo
import numpy
import Part
import pytest
import sample_shapes
from laminate_offset import cli, files

Vector = FreeCAD.Vector
TAPE = lo.Material("tape", cured_thickness=0.25, density=1600.0, roll_width=300.0)
CORE = lo.Material("core", cured_thickness=5.0, areal_weight=240.0)


def sandwich(**options) -> lo.Layup:
    """Two plies, a core, one ply."""
    plies = (lo.Ply("A", "tape"), lo.Ply("B", "tape", angle=90.0), lo.Ply("C", "core"), lo.Ply("D", "tape", angle=45.0))
    return lo.Layup(plies, (TAPE, CORE), **options)


@pytest.mark.parametrize("direction, reference", [("normal", "tool"), ("reversed", "tool"), ("normal", "middle")])
def test_mass_on_a_cylinder_is_the_closed_form(direction: str, reference: str) -> None:
    radius, height = 50.0, 80.0
    face = sample_shapes.cylinder_face(radius, height)
    stack = lo.stack_plies(face, sandwich(direction=direction, reference=reference))
    figures = stack.mass_properties()
    mass = 0.0
    for ply, figure in zip(stack.plies, figures.plies):
        inner, outer = sorted((radius + ply.ply.bottom, radius + ply.ply.top))
        volume = math.pi * height * (outer**2 - inner**2)
        area = 2.0 * math.pi * height * (radius + ply.ply.middle)
        expected = volume * 1600e-9 if figure.material == "tape" else area * 240e-9
        mass += expected
        assert figure.volume == pytest.approx(volume, rel=1e-9) and ply.volume == figure.volume
        assert figure.area == pytest.approx(area, rel=1e-9) and ply.area == figure.area
        assert figure.mass == pytest.approx(expected, rel=1e-9) and ply.mass == figure.mass
        assert (figure.center - Vector(0.0, 0.0, 40.0)).Length < 1e-7 and ply.center == figure.center
    assert figures.mass == pytest.approx(mass, rel=1e-9)
    assert figures.thickness == 5.75 and (figures.center - Vector(0.0, 0.0, 40.0)).Length < 1e-7
    tape, core = figures.materials
    assert (tape.material, tape.plies, core.material, core.plies) == ("tape", 3, "core", 1)
    assert tape.roll_length == pytest.approx(tape.area / 300.0) and core.roll_length is None
    assert json.loads(json.dumps(figures.to_dict()))["plies"][0]["center"][2] == pytest.approx(40.0)


def test_mass_on_a_sphere_and_on_a_plane_with_a_hole() -> None:
    stack = lo.stack_plies(sample_shapes.sphere_face(100.0), sandwich())
    for ply in stack.plies:
        shell = 4.0 / 3.0 * math.pi * ((100.0 + ply.ply.top) ** 3 - (100.0 + ply.ply.bottom) ** 3)
        assert ply.volume == pytest.approx(shell, rel=1e-9)
    flat = lo.stack_plies(sample_shapes.plane_face(), sandwich())
    area = 900.0 - 25.0 * math.pi
    for ply in flat.plies:
        assert ply.volume == pytest.approx(area * ply.ply.thickness, rel=1e-9)
        height = ply.ply.middle * sample_shapes.plane_face().normalAt(0.0, 0.0).z
        assert (ply.center - Vector(15.0, 15.0, height)).Length < 1e-9


@pytest.mark.parametrize("kind", ["sphere", "torus"])
@pytest.mark.parametrize("inwards", [False, True])
@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_solids_of_closed_faces_have_an_outer_and_an_inner_shell(kind: str, inwards: bool, direction: str) -> None:
    whole = Part.makeSphere(100.0) if kind == "sphere" else Part.makeTorus(200.0, 100.0)
    whole.Placement = FreeCAD.Placement(Vector(500.0, -40.0, 7.0), FreeCAD.Rotation(Vector(1.0, 2.0, 3.0), 40.0))
    face = whole.Faces[0].reversed() if inwards else whole.Faces[0]
    stack = lo.stack_plies(face, sandwich(), direction=direction, solids=True)
    sign = 1.0 if (direction == "normal") != inwards else -1.0

    def held(distance: float) -> float:
        radius = 100.0 + sign * distance
        return 4.0 / 3.0 * math.pi * radius**3 if kind == "sphere" else 2.0 * math.pi**2 * 200.0 * radius**2

    spans = [(abs(ply.ply.bottom), abs(ply.ply.top), ply.solid) for ply in stack.plies]
    spans.append((0.0, stack.report["thickness"], stack.laminate_solid()))
    for low, high, solid in spans:
        assert solid.isValid() and solid.isClosed() and len(solid.Shells) == 2 and len(solid.Faces) == 2
        assert solid.Volume == pytest.approx(abs(held(high) - held(low)), rel=1e-6)
        outer, inner = solid.Shells
        assert outer.BoundBox.DiagonalLength > inner.BoundBox.DiagonalLength
        radius = 100.0 + 0.5 * sign * (low + high)
        local = Vector(0.0, 0.0, radius) if kind == "sphere" else Vector(200.0, 0.0, radius)
        assert solid.isInside(whole.Placement.multVec(local), 1e-6, False)
        assert not solid.isInside(whole.Placement.multVec(local * (90.0 / radius)), 1e-6, False)


def test_a_material_without_figures_has_no_mass() -> None:
    layup = lo.Layup((lo.Ply("A", "tape"), lo.Ply("B", "paper", 0.1)), (TAPE,))
    figures = lo.stack_plies(sample_shapes.bspline_face(), layup).mass_properties()
    assert figures.plies[0].mass > 0.0 and figures.plies[1].mass is None and figures.mass is None
    assert figures.volume > 0.0 and figures.materials[1].mass is None


@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_solids_of_a_free_form_face(direction: str) -> None:
    face = sample_shapes.trimmed_bspline_face()
    stack = lo.stack_plies(face, sandwich(direction=direction), 1e-4, solids=True)
    figures = stack.mass_properties()
    for ply, figure in zip(stack.plies, figures.plies):
        assert ply.solid.ShapeType == "Solid" and ply.solid.isValid() and ply.solid.isClosed()
        assert len(ply.solid.Faces) == 2 + len(face.Edges)
        assert ply.solid.Volume == pytest.approx(figure.volume, abs=3e-4 * figure.area)
        assert (ply.solid.CenterOfMass - figure.center).Length < 0.05
    for lower, upper in zip(stack.plies, stack.plies[1:]):
        assert sum(a.isSame(b) for a in lower.solid.Faces for b in upper.solid.Faces) == 1
    groups = stack.material_solids()
    assert [(group.material, len(group.plies)) for group in groups] == [("tape", 2), ("core", 1), ("tape", 1)]
    assert all(group.solid.isValid() for group in groups)
    whole = stack.laminate_solid()
    assert whole.isValid() and whole.Volume == pytest.approx(figures.volume, abs=3e-4 * figures.area)
    assert whole.Volume == pytest.approx(sum(group.solid.Volume for group in groups), rel=1e-6)
    assert len(stack.to_shape(solids=True).Solids) == 4


def test_the_solids_of_a_creased_face_are_those_of_its_parts() -> None:
    face = sample_shapes.moved(sample_shapes.roof_face(20.0, 50.0))
    stack = lo.stack_plies(face, sandwich())
    (warning,) = stack.report["warnings"]
    assert "2 parts, which stand apart there by up to" in warning and "one for each part" in warning
    area = 20.0 * math.sqrt(2.0) * 50.0  # of one side of the roof
    for ply in stack.plies:
        assert ply.solid.ShapeType == "Compound" and len(ply.solid.Solids) == 2 and ply.solid.isValid()
        for solid in ply.solid.Solids:
            assert solid.isValid() and solid.isClosed() and len(solid.Faces) == 6
            assert solid.Volume == pytest.approx(area * ply.ply.thickness, rel=1e-9)
        assert ply.solid.Volume == pytest.approx(ply.volume, rel=1e-6)
    for lower, upper in zip(stack.plies, stack.plies[1:]):
        assert sum(a.isSame(b) for a in lower.solid.Faces for b in upper.solid.Faces) == 2  # one in each part
    # at the crease the parts of the farthest ply stand apart by sqrt(2) times its distances
    one, other = stack.plies[-1].solid.Solids
    assert one.common(other).Volume < 1e-6
    assert one.distToShape(other)[0] == pytest.approx(math.sqrt(2.0) * stack.plies[-1].ply.bottom, rel=1e-6)
    groups = stack.material_solids()
    assert [len(group.solid.Solids) for group in groups] == [2, 2, 2]
    whole = stack.laminate_solid()
    assert whole.isValid() and whole.Volume == pytest.approx(sum(group.solid.Volume for group in groups), rel=1e-9)
    assert len(stack.to_shape(solids=True).Solids) == 8


def test_plies_that_cross_at_a_crease_have_no_solids() -> None:
    face = sample_shapes.roof_face()
    stack = lo.stack_plies(face, sandwich(direction="reversed"))
    (warning,) = stack.report["warnings"]
    assert "cross each other there" in warning and "other side" in warning
    with pytest.raises(lo.OffsetError, match="cross each other.*other side, or round the crease") as refused:
        stack.laminate_solid()
    assert refused.value.status == "kinked-surface" and refused.value.stage == "topology"
    assert refused.value.where["y"] == pytest.approx(0.0, abs=1e-6) and refused.value.where["z"] == pytest.approx(0.0)
    with pytest.raises(lo.OffsetError, match="cross each other"):
        lo.stack_plies(face, sandwich(reference="middle"), solids=True)
    (warning,) = lo.stack_plies(face, sandwich(reference="middle")).report["warnings"]
    assert "stack all plies on the side that opens, or round" in warning
    flat = lo.stack_plies(sample_shapes.bspline_face(), sandwich())
    assert flat.report["warnings"] == []


def test_the_other_side_is_no_remedy_where_both_cross() -> None:
    heights = [1.0] * 8 + [-1.0] * 4 + [1.0] * 8  # of a ridge that is a valley in its middle
    poles = [[FreeCAD.Vector(10.0 * i, y, h * (y == 0.0)) for i, h in enumerate(heights)] for y in (-20.0, 0.0, 20.0)]
    surface = Part.BSplineSurface()
    knots = list(range(len(heights) - 2))
    surface.buildFromPolesMultsKnots(
        poles, [2, 1, 2], [4] + [1] * (len(knots) - 2) + [4], [0, 1, 2], knots, False, False, 1, 3
    )
    for direction in ("normal", "reversed"):
        stack = lo.stack_plies(surface.toShape(), lo.Layup((lo.Ply("P1", "tape", 1.0),), direction=direction))
        (warning,) = stack.report["warnings"]
        assert "have no solids; round the creases." in warning
        with pytest.raises(lo.OffsetError, match="no solids; round the crease by a radius") as refused:
            stack.laminate_solid()
        assert refused.value.status == "kinked-surface"


@pytest.mark.parametrize("second, crossing", [(-5.0, "reversed"), (5.0, "normal")])
def test_a_cusp_is_warned_of_on_both_sides(second: float, crossing: str) -> None:
    # two skins that are tangent to each other at their common edge; the second one ends below or above the first one, whose
    # normal is upwards
    heights = [(50.0, 10.0), (25.0, 0.0), (0.0, 0.0), (25.0, 0.0), (50.0, 10.0 + second)]
    poles = [[Vector(x, y, z) for y in (40.0, 0.0)] for x, z in heights]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(poles, [3, 2, 3], [2, 2], [0, 1, 2], [0, 1], False, False, 2, 1)
    face = surface.toShape()
    for direction in ("normal", "reversed"):
        stack = lo.stack_plies(face, lo.Layup((lo.Ply("P1", "tape", 0.5),), direction=direction))
        (warning,) = stack.report["warnings"]
        if direction == crossing:
            assert "cross each other there by up to 1 mm, so that they have no solids" in warning
            assert "other side" in warning
        else:
            assert "stand apart there by up to 1 mm; whether they meet elsewhere could not be settled" in warning
        with pytest.raises(lo.OffsetError) as refused:
            stack.laminate_solid()
        assert refused.value.status == ("kinked-surface" if direction == crossing else "not-supported")
        assert abs(refused.value.where["x"]) < 1e-6, "it is the cusp that is named"


def test_plies_that_come_upon_another_part_of_a_creased_face_have_no_solids() -> None:
    hook = [(0, 0), (0, -20), (20, -20), (20, 20), (-20, 20), (-20, 0.3), (-0.4, 0.3)]
    poles = [FreeCAD.Vector(x, y, 0) for x, y in hook]
    profile = Part.BSplineCurve()
    profile.buildFromPolesMultsKnots(poles, [2] + [1] * (len(hook) - 2) + [2], range(len(hook)), False, 1)
    face = profile.toShape().extrude(FreeCAD.Vector(0, 0, 50)).Faces[0]
    plies = lo.Layup((lo.Ply("P1", "tape", 0.5), lo.Ply("P2", "tape", 0.5)), direction="reversed")
    with pytest.raises(lo.OffsetError, match="another part of the creased face; use a smaller distance") as refused:
        lo.offset_face(face, -1.0)
    assert refused.value.status == "self-intersection" and refused.value.stage == "surface"
    tip = [lo.Ply("P1", "tape", 0.1), lo.Ply("P2", "tape", 0.1)]
    assert len(lo.stack_plies(face, lo.Layup(tuple(tip), direction="reversed")).laminate_solid().Solids) == 6
    thick = lo.Layup((lo.Ply("P1", "tape", 6.0),), direction="reversed")
    for laid in (plies, thick):
        with pytest.raises(
            lo.OffsetError, match="another part of the creased face; lay fewer or thinner plies, or split"
        ) as refused:
            lo.stack_plies(face, laid, solids=True)
        where = refused.value.where
        assert refused.value.status == "self-intersection" and where is not None
        assert abs(where["x"]) < 20.1 and abs(where["y"]) < 20.1 and -1e-6 < where["z"] < 50.0 + 1e-6


def test_fibres_on_a_cylinder_follow_the_projected_axis() -> None:
    face = sample_shapes.cylinder_face(10.0, 20.0)
    stack = lo.stack_plies(face, sandwich())
    uv = numpy.array([[0.3, 5.0], [2.0, 10.0], [5.5, 1.0]])
    axes = lo.Rosette((10.0, 0.0, 0.0), (0.5, 0.0, 2.0))
    normals = numpy.stack([numpy.cos(uv[:, 0]), numpy.sin(uv[:, 0]), 0.0 * uv[:, 0]], axis=1)
    up = numpy.array([[0.0, 0.0, 1.0]] * 3)
    across = numpy.cross(normals, up)
    assert numpy.allclose(stack.fibre_directions(1, uv, axes), up, atol=1e-12)
    assert numpy.allclose(stack.fibre_directions(2, uv, axes), across, atol=1e-12)
    slanted = stack.fibre_directions(stack.plies[3], uv, axes)
    assert numpy.allclose(slanted, (up + across) / math.sqrt(2.0), atol=1e-12)
    with pytest.raises(ValueError, match="stands on the surface"):
        stack.fibre_directions(1, [[0.5 * math.pi, 1.0]], lo.Rosette((10.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
    with pytest.raises(ValueError, match="no ply 5"):
        stack.fibre_directions(5, uv, axes)
    with pytest.raises(ValueError, match="direction"):
        lo.Rosette((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


def test_fibres_are_tangent_unit_vectors_on_free_form() -> None:
    face = sample_shapes.moved(sample_shapes.bspline_face())
    stack = lo.stack_plies(face, sandwich())
    places = numpy.random.default_rng(7).uniform(size=(40, 2))
    u0, u1, v0, v1 = face.ParameterRange
    uv = numpy.array([u0, v0]) + places * numpy.array([u1 - u0, v1 - v0])
    for number in (1, 2, 4):
        directions = stack.fibre_directions(number, uv, lo.Rosette((0.0, 0.0, 0.0), (1.0, 0.2, 0.0)))
        normals = numpy.array([tuple(face.normalAt(*row)) for row in uv])
        assert numpy.allclose(numpy.linalg.norm(directions, axis=1), 1.0)
        assert numpy.abs(numpy.sum(directions * normals, axis=1)).max() < 1e-9


def test_thickness_and_core_samples() -> None:
    face = sample_shapes.trimmed_bspline_face()
    stack = lo.stack_plies(face, sandwich(direction="reversed"))
    u0, u1, v0, v1 = face.ParameterRange
    at = (u0 + 0.2 * (u1 - u0), v0 + 0.3 * (v1 - v0))
    hole = (0.5 * (u0 + u1), 0.5 * (v0 + v1))
    assert stack.thickness(numpy.array([at, hole])).tolist() == [5.75, 0.0]
    point = face.valueAt(*at) + face.normalAt(*at) * 3.0
    assert stack.thickness([tuple(point)]).tolist() == [5.75]
    sample = stack.core_sample(point)
    assert sample.uv == pytest.approx(at, abs=1e-6) and sample.thickness == pytest.approx(5.75)
    assert [layer.ply.ply.name for layer in sample.layers] == ["A", "B", "C", "D"]
    assert [(layer.bottom, layer.top) for layer in sample.layers] == [
        (0.0, -0.25),
        (-0.25, -0.5),
        (-0.5, -5.5),
        (-5.5, -5.75),
    ]
    for layer in sample.layers:
        for face_of_ply, end in ((layer.ply.bottom_face, layer.start), (layer.ply.top_face, layer.end)):
            assert face_of_ply.distToShape(Part.Vertex(end))[0] < 2e-3
    line = stack.core_sample_line(face.valueAt(*at), face.valueAt(*hole), 9)
    assert len(line) == 9 and line[0].thickness == pytest.approx(5.75) and not line[-1].layers
    with pytest.raises(ValueError, match="2 or more"):
        stack.core_sample_line((0, 0, 0), (1, 0, 0), 1)
    with pytest.raises(ValueError, match="shape"):
        stack.thickness([1.0, 2.0])


def test_there_are_no_plies_beside_the_face() -> None:
    stack = lo.stack_plies(Part.makePlane(200.0, 100.0).Faces[0], sandwich())
    beside = [[-500, 50, 0], [100, -400, 0], [500, 50, 0], [-1e-3, 50, 7], [200.001, 50, 0]]
    above = [[100, 50, 30], [0, 0, 0], [0, 50, 0], [200, 50, 0], [200, 100, -40], [100, 100, 4]]
    assert stack.thickness(beside).tolist() == [0.0] * 5
    assert stack.thickness(above).tolist() == [5.75] * 6
    assert not any(stack.core_sample(point).layers for point in beside)
    assert all(len(stack.core_sample(point).layers) == 4 for point in above)
    assert (
        stack.thickness([[0, 50], [200, 50], [100, 0], [200, 100], [-1, 50], [201, 50]]).tolist()
        == [5.75] * 4 + [0.0] * 2
    )
    low, high = stack.plies[1].levels([[0.0, 50.0], [200.0, 100.0], [201.0, 50.0]])
    assert low[:2].tolist() == [0.25] * 2 and high[:2].tolist() == [0.5] * 2
    assert numpy.isnan([low[2], high[2]]).all()


@pytest.mark.parametrize("placed", [False, True])
def test_lines_from_edge_to_edge_count_both_ends(placed: bool) -> None:
    face = sample_shapes.bspline_face()
    face = sample_shapes.moved(face) if placed else face
    stack = lo.stack_plies(face, sandwich())
    u0, u1, v0, v1 = face.ParameterRange
    for share in numpy.linspace(0.0, 1.0, 9):
        u, v = u0 + share * (u1 - u0), v0 + share * (v1 - v0)
        for start, end in (((u, v0), (u, v1)), ((u0, v), (u1, v))):
            line = stack.core_sample_line(face.valueAt(*start), face.valueAt(*end), 3)
            assert [len(sample.layers) for sample in (line[0], line[-1])] == [4, 4]
    rng = numpy.random.default_rng(11)
    for u, v in rng.uniform(size=(60, 2)) * [u1 - u0, v1 - v0] + [u0, v0]:
        point = face.valueAt(u, v) + face.normalAt(u, v) * rng.uniform(-3, 3)
        assert stack.thickness([tuple(point)]).tolist() == [5.75]
    past = face.valueAt(u0, v0) + (face.valueAt(u0, v0) - face.valueAt(u1, v1)) * 0.5
    assert stack.thickness([tuple(past)]).tolist() == [0.0] and not stack.core_sample(past).layers


def test_the_edge_of_a_hole_belongs_to_the_face() -> None:
    stack = lo.stack_plies(sample_shapes.plane_face(), sandwich())
    turns = numpy.linspace(0.0, 2.0 * math.pi, 25)
    rings = [[(15 + r * math.cos(turn), 15 + r * math.sin(turn), 2.0) for turn in turns] for r in (4.9, 5.0, 5.01)]
    assert [set(stack.thickness(ring).tolist()) for ring in rings] == [{0.0}, {5.75}, {5.75}]


def test_all_around_a_cylinder_there_are_plies() -> None:
    stack = lo.stack_plies(sample_shapes.cylinder_face(10.0, 20.0), sandwich())
    turns = numpy.linspace(-math.pi, math.pi, 33)
    around = [(12 * math.cos(turn), 12 * math.sin(turn), height) for turn in turns for height in (0.0, 5.0, 20.0)]
    assert set(stack.thickness(around).tolist()) == {5.75}
    past = [(12 * math.cos(turn), 12 * math.sin(turn), height) for turn in turns for height in (-0.01, 21.0)]
    assert set(stack.thickness(past).tolist()) == {0.0}


def test_rosettes_by_name() -> None:
    rows = (lo.Ply("A", "tape", rosette="nose"), lo.Ply("B", "tape", rosette="tail"), lo.Ply("C", "tape"))
    face = sample_shapes.cylinder_face(10.0, 20.0)
    stack = lo.stack_plies(face, lo.Layup(rows, (TAPE,)))
    along, around = lo.Rosette((10.0, 0.0, 0.0), (0.0, 0.0, 1.0)), lo.Rosette((10.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    axes = {"nose": along, "tail": around, "": along}
    found = [stack.fibre_directions(number, [[0.0, 5.0]], axes)[0] for number in (1, 2, 3)]
    assert numpy.allclose(found, [[0, 0, 1], [0, 1, 0], [0, 0, 1]], atol=1e-12)
    with pytest.raises(ValueError, match="different rosettes .'nose', 'tail', none.*give all of them"):
        stack.fibre_directions(1, [[0.0, 5.0]], along)
    with pytest.raises(ValueError, match="no rosette 'tail'.*it has 'nose'"):
        stack.fibre_directions(2, [[0.0, 5.0]], {"nose": along})
    for wrong in ((10.0, 0.0, 0.0), None, {"nose": (0.0, 0.0, 1.0)}):
        with pytest.raises(TypeError, match="axes.*must be a Rosette"):
            stack.fibre_directions(1, [[0.0, 5.0]], wrong)
    for wrong in (True, "1", 1.0):
        with pytest.raises(TypeError, match="ply must be a StackPly or its number"):
            stack.fibre_directions(wrong, [[0.0, 5.0]], axes)
    inactive = lo.Layup((rows[0], lo.Ply("B", "tape", rosette="tail", active=False)), (TAPE,))
    only = lo.stack_plies(face, inactive)
    assert numpy.allclose(only.fibre_directions(1, [[0.0, 5.0]], along), [[0, 0, 1]], atol=1e-12)


def test_reduced_plies_have_no_more_poles() -> None:
    face = sample_shapes.trimmed_bspline_face()
    shared = lo.stack_plies(face, sandwich())
    single = lo.stack_plies(face, sandwich(), reduce=True)
    poles = [
        [ply.report.surface["poles_u"] * ply.report.surface["poles_v"] for ply in s.plies] for s in (shared, single)
    ]
    assert all(few <= many for many, few in zip(*poles)) and sum(poles[1]) < sum(poles[0])
    assert single.report["certified_error"] <= 1e-3 and single.laminate_solid().isValid()
    assert not single.report["one_fit"] and all(ply.solid.isValid() for ply in single.plies)


def test_the_command_writes_solids(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table, output = tmp_path / "base.brep", tmp_path / "layup.csv", tmp_path / "plies.step"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\nP2,tape,0.3,90\n", encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "--solids", "-o", str(output)]
    assert cli.main(arguments) == 0
    written = Part.Shape()
    written.read(str(output))
    assert len(written.Solids) == 2 and all(solid.isValid() and solid.Volume > 0.0 for solid in written.Solids)
