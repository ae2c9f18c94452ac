# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature maps, fold regions, exploded stacks and sections: what is drawn, without the GUI."""

import json
import math
import os
import pathlib

import FreeCAD as App
import laminate_offset as lo
import numpy
import Part
import pytest
from laminate_offset.features.contour import zero_curves
from laminate_offset.features.core_sample import make_core_sample
from laminate_offset.features.curvature_map import SHOWN, make_curvature_map, shown_values
from laminate_offset.features.exploded import exploded, usual_direction, usual_factor
from laminate_offset.features.fold_region import fold_region
from laminate_offset.features.layup import import_layup, make_layup, set_layup
from laminate_offset.features.offset_face import make_offset_face
from laminate_offset.features.plane_section import plane_cuts
from laminate_offset.features.ply_stack import make_ply_stack, result_of
from laminate_offset.features.stack_section import cuts_of, make_stack_section, set_usual_plane, usual_exaggeration
from laminate_offset.features.trimmed_grid import Patch, clipped, trimmed_grid
from laminate_offset.layup import Layup, Ply, layup_from_notation
from shapes import wavy_face

EXAMPLES = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset" / "resources" / "examples"


@pytest.fixture
def wavy(doc):
    """A free-form face."""
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    return base


@pytest.fixture
def stack(doc, wavy):
    """Six plies, 0.848 mm, on the free-form face."""
    return make_ply_stack(wavy, "Face1", import_layup(doc, str(EXAMPLES / "layup_plain.csv")))


@pytest.fixture
def plate(doc):
    """A flat face of 100 x 60 mm in the plane z = 0."""
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length, plane.Width = 100, 60
    doc.recompute()
    return plane


def is_invalid(feature):
    return "Invalid" in feature.State


def area(points, triangles):
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    return 0.5 * numpy.linalg.norm(numpy.cross(b - a, c - a), axis=-1).sum()


# Grids


def test_grid_is_cut_at_the_loops():
    face = Part.read(str(EXAMPLES / "panel_two_holes.step")).Faces[0]
    patch = trimmed_grid(face, 64)
    points = lo._core.evaluate_face(face, patch.uv)[0]
    assert area(points, patch.triangles) == pytest.approx(face.Area, rel=2e-3)
    outer = Part.Face(face.Surface).Area
    assert face.Area < 0.95 * outer, "the face must be trimmed"
    assert lo._core.evaluate_face(face, patch.uv)[2].mean() > 0.95


@pytest.mark.parametrize("limit", [0.0, 0.31, 0.5, 1.0, 1.3, 2.0])
def test_clipping_keeps_the_area_where_the_test_holds(limit):
    grid = numpy.linspace(0, 1, 9)
    uv = numpy.array([(u, v) for u in grid for v in grid])
    index = numpy.arange(81).reshape(9, 9)
    a, b, c, d = (index[:-1, :-1].ravel(), index[1:, :-1].ravel(), index[1:, 1:].ravel(), index[:-1, 1:].ravel())
    patch = Patch(uv, numpy.concatenate([numpy.column_stack([a, b, c]), numpy.column_stack([a, c, d])]))
    part = clipped(patch, lambda places: places.sum(axis=1) <= limit)
    found = area(numpy.column_stack([part.uv, numpy.zeros(len(part.uv))]), part.triangles) if len(part.triangles) else 0
    expected = limit**2 / 2 if limit <= 1 else 1 - (2 - limit) ** 2 / 2
    assert found == pytest.approx(expected, abs=2e-3)
    turned = numpy.cross(
        part.uv[part.triangles[:, 1]] - part.uv[part.triangles[:, 0]],
        part.uv[part.triangles[:, 2]] - part.uv[part.triangles[:, 0]],
    )
    assert (turned >= 0).all(), "triangles keep their side"


def test_curves_are_chained_and_lie_on_the_zero():
    grid = numpy.linspace(-1, 1, 12)
    uv = numpy.array([(u, v) for u in grid for v in grid])
    index = numpy.arange(144).reshape(12, 12)
    a, b, c, d = (index[:-1, :-1].ravel(), index[1:, :-1].ravel(), index[1:, 1:].ravel(), index[:-1, 1:].ravel())
    patch = Patch(uv, numpy.concatenate([numpy.column_stack([a, b, c]), numpy.column_stack([a, c, d])]))
    (circle,) = zero_curves(patch, lambda places: (places**2).sum(axis=1) - 0.5)
    assert numpy.allclose((circle**2).sum(axis=1), 0.5, atol=1e-12) and (circle[0] == circle[-1]).all()
    length = numpy.linalg.norm(numpy.diff(circle, axis=0), axis=1).sum()
    assert length == pytest.approx(2 * math.pi * math.sqrt(0.5), rel=1e-2)
    both = zero_curves(patch, lambda places: numpy.abs(places[:, 0]) - 0.37)
    assert len(both) == 2 and all(numpy.ptp(curve[:, 1]) == pytest.approx(2) for curve in both)
    assert zero_curves(patch, lambda places: places[:, 0] + 5) == []


# Curvature maps


def test_map_of_a_cylinder_is_known_in_closed_form(doc):
    can = doc.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 4, 10
    doc.recompute()
    chart = make_curvature_map(can, "Face1", -3)
    assert chart.Status == "ok" and chart.LargestUse == pytest.approx(0.75) and chart.FoldedArea.Value == 0
    assert chart.Inwards.Value == pytest.approx(-4) and math.isnan(chart.Outwards.Value)
    assert shown_values(chart) == pytest.approx(0.75) and len(chart.Points) > 1000
    chart.Distance = -5
    doc.recompute()
    assert chart.LargestUse == pytest.approx(1.25) and "folds on" in chart.Message
    assert chart.FoldedArea.Value == pytest.approx(2 * math.pi * 4 * 10, rel=1e-2)
    chart.Distance = 50
    doc.recompute()
    assert chart.LargestUse == pytest.approx(0.0, abs=1e-9)
    chart.Shows = SHOWN[2]
    assert shown_values(chart) == pytest.approx(0.25)
    chart.Shows = SHOWN[1]
    assert shown_values(chart) == pytest.approx(0.0, abs=1e-12)


def test_map_agrees_with_the_proven_limits(doc, wavy):
    limits = lo.offset_limits(wavy.Shape.Face1)
    chart = make_curvature_map(wavy, "Face1", 20)
    # Sampled limits are never tighter than the true ones, which the proven ones meet within some 0.1 %.
    assert limits.positive * 0.999 <= chart.Outwards.Value <= limits.positive * 1.02
    assert limits.negative * 1.02 <= chart.Inwards.Value <= limits.negative * 0.999
    assert chart.LargestUse == pytest.approx(20 / chart.Outwards.Value)


def test_map_of_several_faces_in_a_moved_container(doc):
    box = doc.addObject("Part::Cylinder", "Can")
    part = doc.addObject("App::Part", "Part")
    part.Placement.Base = App.Vector(100, 0, 0)
    part.addObject(box)
    doc.recompute()
    chart = make_curvature_map(box, ["Face1", "Face2", "Face3"], -1)
    assert len(chart.Corners) % 3 == 0 and max(chart.Corners) == len(chart.Points) - 1
    assert min(point.x for point in chart.Points) >= 98 - 1e-9
    assert chart.LargestUse == pytest.approx(0.5) and shown_values(chart).min() == 0
    doc.removeObject(box.Name)
    chart.touch()
    doc.recompute()
    assert is_invalid(chart) and chart.LargestUse == 0


# Fold regions


def test_refused_offset_tells_the_region_that_folds(doc, ball):
    offset = make_offset_face(ball, "Face1", -12)
    assert offset.Status == "curvature-limit" and len(offset.FoldPoints) > 100
    points, triangles = (
        numpy.array(list(map(tuple, offset.FoldPoints))),
        numpy.array(offset.FoldCorners).reshape(-1, 3),
    )
    assert area(points, triangles) == pytest.approx(ball.Shape.Face1.Area, rel=2e-2), "all of a sphere folds"
    assert numpy.allclose(numpy.linalg.norm(points, axis=1), 10)
    offset.Distance = 3
    doc.recompute()
    assert offset.Status == "ok" and offset.FoldPoints == [] and offset.FoldCorners == []


@pytest.mark.parametrize("distance", [45.0, -60.0])
def test_region_is_where_the_factors_are_not_positive(wavy, distance):
    face = wavy.Shape.Face1
    region = fold_region(face, [distance])
    inside = area(region.points, region.triangles)
    assert 1 < inside < 0.9 * face.Area
    # FreeCAD's own curvatures on a grid of our choice: H and K do not depend on the normal's side but for H's sign.
    u0, u1, v0, v1 = face.ParameterRange
    folded = total = 0.0
    for i in range(80):
        for j in range(80):
            u, v = u0 + (u1 - u0) * (i + 0.5) / 80, v0 + (v1 - v0) * (j + 0.5) / 80
            normal = face.normalAt(u, v)
            bend = face.Surface.getDN(u, v, 2, 0), face.Surface.getDN(u, v, 1, 1), face.Surface.getDN(u, v, 0, 2)
            du, dv = face.Surface.getDN(u, v, 1, 0), face.Surface.getDN(u, v, 0, 1)
            first = numpy.array([[du.dot(du), du.dot(dv)], [du.dot(dv), dv.dot(dv)]])
            second = numpy.array(
                [[bend[0].dot(normal), bend[1].dot(normal)], [bend[1].dot(normal), bend[2].dot(normal)]]
            )
            shape = numpy.linalg.solve(first, second)
            mean, gauss = 0.5 * numpy.trace(shape), numpy.linalg.det(shape)
            patch = du.cross(dv).Length
            total += patch
            if 1 - 2 * mean * distance + gauss * distance**2 <= 0 or 1 - mean * distance <= 0:
                folded += patch
    assert inside / face.Area == pytest.approx(folded / total, abs=0.01)


def test_small_region_is_found_at_the_place_of_the_refusal(wavy):
    face = wavy.Shape.Face1
    limits = lo.offset_limits(face)
    distance = limits.positive * 1.002
    region = fold_region(face, [distance], limits.where_positive)
    assert len(region.triangles) and area(region.points, region.triangles) < 0.01 * face.Area
    place = numpy.array([limits.where_positive[axis] for axis in "xyz"])
    assert numpy.linalg.norm(region.points - place, axis=1).min() < 3
    assert len(fold_region(face, [0.5 * limits.positive], limits.where_positive).triangles) == 0


def test_refused_stack_tells_the_region(doc, wavy):
    stack = make_ply_stack(wavy, "Face1", make_layup(doc, layup_from_notation("[0]400", "EGlass-7781-Epoxy")))
    assert stack.Status == "curvature-limit" and len(stack.FoldPoints) > 10


# Exploded stacks


def test_exploded_plies_keep_the_document(stack, wavy):
    before = stack.Shape.exportBrepToString()
    factor = usual_factor(stack)
    assert factor > 30 and abs(usual_direction(stack).z) > 0.9
    sheets = exploded(stack, factor)
    assert len(sheets) == 6 and all(len(sheet.lines) == 4 for sheet in sheets)
    base = wavy.Shape.Face1
    for sheet, report in zip(sheets, json.loads(stack.ReportJson)):
        feet = lo.nearest_point(base, sheet.points)
        normals = lo._core.evaluate_face(base, feet.uv)[1]
        level = ((sheet.points - feet.points) * normals).sum(axis=1)
        near = numpy.abs(level) < 14  # past the radius of curvature another foot is nearer
        assert numpy.allclose(level[near], factor * report["top"], atol=2e-3 * factor) or report["top"] * factor > 14
    assert stack.Shape.exportBrepToString() == before and "Touched" not in stack.State


def test_exploded_along_a_direction_moves_plies_as_a_whole(stack):
    as_it_is = exploded(stack, 1.0)
    moved = exploded(stack, 101.0, "direction", (0, 0, 2))
    for sheet, there, report in zip(as_it_is, moved, json.loads(stack.ReportJson)):
        assert numpy.allclose(there.points - sheet.points, (0, 0, 100 * report["top"]))
        assert all(numpy.allclose(a - b, (0, 0, 100 * report["top"])) for a, b in zip(there.lines, sheet.lines))


def test_exploded_solids_and_closed_faces(doc, ball, stack):
    stack.Solids = True
    doc.recompute()
    (low, *_, high) = exploded(stack, 10.0, "direction", (0, 0, 1))
    assert len(low.lines) == 12 and high.points[:, 2].max() > low.points[:, 2].max() + 5
    around = make_ply_stack(ball, "Face1", stack.Layup)
    assert usual_direction(around) is None
    sheet = exploded(around, 5.0)[-1]
    assert numpy.allclose(numpy.linalg.norm(sheet.points, axis=1), 10 + 5 * 0.848, atol=0.05)


# Sections


def test_section_of_a_flat_stack_is_exact(doc, plate):
    layup = make_layup(doc, layup_from_notation("[0/90/0]", "IM7-8552-134"))
    stack = make_ply_stack(plate, "Face1", layup)
    cut = make_stack_section(stack, (2, 0, 0), 40)
    assert cut.Status == "ok" and cut.PlyCount == 3 and cut.Length.Value == pytest.approx(60, abs=0.02)
    assert [face.Area for face in cut.Shape.Faces] == pytest.approx([60 * 0.131] * 3, rel=1e-3)
    box = cut.Shape.BoundBox
    assert (box.XMin, box.XMax) == (pytest.approx(40), pytest.approx(40)) and box.ZLength == pytest.approx(0.393)
    assert cut.Shape.isValid() and all(face.isValid() for face in cut.Shape.Faces)
    assert usual_exaggeration(cut) == 5.0
    cut.Normal, cut.Position = App.Vector(1, 1, 0), 80 / math.sqrt(2)
    doc.recompute()
    assert cut.Status == "ok" and cut.Length.Value == pytest.approx(math.hypot(60, 60), abs=0.1), cut.Message


def test_section_of_a_curved_stack_lies_on_the_plies(stack):
    normal = numpy.array([0.6, 0.0, 0.8])
    result = result_of(stack)
    cuts = plane_cuts(result, normal, 22.0, 48)
    assert sorted({cut.number for cut in cuts}) == [1, 2, 3, 4, 5, 6]
    seen = 0
    for cut in cuts:
        ply = result.plies[cut.number - 1]
        outline = cut.outline()
        half = len(cut.trace)
        assert numpy.abs(outline @ normal - 22.0).max() < 1e-9, "all corners lie in the plane"
        for face, corners in ((ply.bottom_face, outline[:half]), (ply.top_face, outline[half:])):
            for corner in corners[2:-2:9]:
                assert Part.Vertex(App.Vector(*corner)).distToShape(face)[0] <= 2e-3
                seen += 1
    assert seen > 50


def test_exaggeration_scales_the_distances_from_the_face_only(stack):
    cut = make_stack_section(stack, (1, 0, 0), 30)
    area_before = cut.Shape.Area
    for piece in cuts_of(cut):
        true, drawn = piece.outline(), piece.outline(10.0)
        feet = numpy.concatenate([piece.trace, piece.trace[::-1]])
        assert numpy.allclose(drawn - feet, 10.0 * (true - feet), atol=1e-9)
    assert cut.Shape.Area == area_before
    for piece, face in zip(cuts_of(cut), cut.Shape.Faces):
        for corner in piece.outline()[::7]:
            assert Part.Vertex(App.Vector(*corner)).distToShape(face.OuterWire)[0] < 1e-6


def test_section_meets_only_the_plies_that_are_there(doc, plate):
    circle = doc.addObject("Part::Circle", "Circle")
    circle.Label, circle.Radius = "Patch", 10
    circle.Placement.Base = App.Vector(50, 28.3, 0)
    layup = make_layup(doc)
    set_layup(layup, Layup((Ply("P1", "A", 0.2), Ply("P2", "A", 0.2, boundary="Patch"), Ply("P3", "A", 0.2))))
    doc.recompute()
    stack = make_ply_stack(plate, "Face1", layup)
    assert stack.Status == "ok", stack.Message
    cut = make_stack_section(stack, (1, 0, 0), 50)
    lengths = {face_index: face.BoundBox.YLength for face_index, face in enumerate(cut.Shape.Faces)}
    assert cut.PlyCount == 3 and sorted(lengths.values())[0] == pytest.approx(20, abs=1.5)
    beside = make_stack_section(stack, (1, 0, 0), 10)
    assert beside.PlyCount == 2 and beside.Shape.BoundBox.ZMax == pytest.approx(0.4, abs=1e-6)
    over = [face for face in cut.Shape.Faces if face.BoundBox.ZMax > 0.5]
    assert len(over) == 1 and over[0].BoundBox.ZMin < 0.21, "the ply above comes down over the ramp"


def test_section_that_misses_is_refused(doc, stack):
    cut = make_stack_section(stack, (1, 0, 0), 30)
    good = cut.Shape.Area
    cut.Position = 700
    doc.recompute()
    assert is_invalid(cut) and cut.OutOfDate and "does not cut" in cut.Message and cut.Shape.Area == good
    cut.Normal = App.Vector(0, 0, 0)
    doc.recompute()
    assert is_invalid(cut) and "normal is zero" in cut.Message
    cut.Stack = None
    doc.recompute()
    assert is_invalid(cut) and "No ply stack" in cut.Message


def test_section_in_a_moved_container(doc, stack):
    """FreeCAD takes the stack and its face along; the plane stays where it is in the document."""
    inside = doc.addObject("App::Part", "Inside")
    inside.Placement = App.Placement(App.Vector(100, 5, 0), App.Rotation(App.Vector(0, 0, 1), 90))
    along_y = make_stack_section(stack, (0, 1, 0), 20).Shape.Faces[0].CenterOfMass
    cut = make_stack_section(stack, (1, 0, 0), 30)
    inside.addObject(cut)
    assert stack in inside.Group
    cut.Position = 80
    doc.recompute()
    assert cut.Status == "ok" and cut.PlyCount == 6, cut.Message
    centre = cut.Shape.Faces[0].CenterOfMass
    assert centre.isEqual(along_y, 1e-6) and abs(inside.Placement.multVec(centre).x - 80) < 1e-9


def test_sections_and_samples_go_along_with_a_stack_that_a_container_takes_in(doc, stack):
    """FreeCAD takes the lay-up face along, and recomputes nothing: what was computed before holds no longer."""
    cut, core = make_stack_section(stack, (1, 0, 0), 30), make_core_sample(stack, (30, 30, 50))
    centre, foot = cut.Shape.Faces[0].CenterOfMass, App.Vector(core.Foot)
    ply = result_of(stack).plies[0].face.CenterOfMass
    container = doc.addObject("App::Part", "Container")
    container.Placement = App.Placement(App.Vector(100, 5, 0), App.Rotation(App.Vector(0, 0, 1), 90))
    container.addObject(stack)
    stack.purgeTouched()
    moved = container.Placement.multVec
    assert result_of(stack).plies[0].face.CenterOfMass.isEqual(moved(ply), 1e-6)
    cut.Normal, cut.Position = App.Vector(0, 1, 0), 35
    core.Point = moved(App.Vector(30, 30, 50))
    doc.recompute()
    assert cut.Status == core.Status == "ok", cut.Message + core.Message
    assert cut in container.Group and cut.PlyCount == 6
    assert cut.Shape.Faces[0].CenterOfMass.isEqual(centre, 1e-6), "in the container it is what it was outside"
    assert core.PlyCount == 6 and core.Foot.isEqual(moved(foot), 1e-6)


def test_usual_plane_meets_a_stack_in_a_moved_container(doc, wavy):
    """The plane is set in the document's frame, where the section is cut."""
    container = doc.addObject("App::Part", "Container")
    container.Placement = App.Placement(App.Vector(1000, 500, 0), App.Rotation(App.Vector(0, 0, 1), 90))
    container.addObject(wavy)
    stack = make_ply_stack(container, "Wavy.Face1", import_layup(doc, str(EXAMPLES / "layup_plain.csv")))
    assert stack.Status == "ok", stack.Message
    cut = make_stack_section(stack, (1, 0, 0), 30)
    assert is_invalid(cut)
    set_usual_plane(cut)
    doc.recompute()
    assert cut.Status == "ok" and cut.PlyCount == 6, cut.Message


def test_maps_and_sections_are_saved_restored_and_copied(doc, wavy, stack, tmp_path):
    chart, cut = make_curvature_map(wavy, "Face1", 60), make_stack_section(stack, (0, 1, 0), 20)
    refused = make_offset_face(wavy, "Face1", 60)
    told = {obj.Name: obj.Message for obj in (chart, cut, refused)}
    corners, folds = list(cut.Corners), len(refused.FoldPoints)
    path = str(tmp_path / "seeing.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        assert {name: reopened.getObject(name).Message for name in told} == told
        again = reopened.getObject(cut_name(told))
        assert list(again.Corners) == corners and len(cuts_of(again)) == 6
        assert len(reopened.OffsetFace.FoldPoints) == folds > 0
        twin = reopened.copyObject(again, False)
        twin.Position = 40
        reopened.recompute()
        assert twin.Status == again.Status == "ok" and twin.Shape.BoundBox.YMin == pytest.approx(40)
        assert again.Shape.BoundBox.YMin == pytest.approx(20)
    finally:
        App.closeDocument(reopened.Name)


def cut_name(told):
    (name,) = [name for name in told if name.startswith("StackSection")]
    return name
