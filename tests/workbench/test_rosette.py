# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rosettes as document objects: what they are attached to, and what counts its angles from them."""

import math

import FreeCAD as App
import Part
import pytest
from laminate_offset.features.layup import make_layup, set_layup
from laminate_offset.features.ply_stack import (
    OUTPUTS,
    link_rosettes,
    make_ply_stack,
    plies_of,
    rosette_for_all,
    rosettes_of,
)
from laminate_offset.features.rosette import make_rosette, rosette_of, set_support
from laminate_offset.gui.commands.export_stack import ExportStackCommand
from laminate_offset.layup import Layup, Ply, layup_from_notation

ROOT = math.sqrt(0.5)


@pytest.fixture
def plate(doc):
    """A flat face of 100 x 60 mm in the plane z = 0, its normal along z."""
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length, plane.Width = 100, 60
    doc.recompute()
    return plane


def is_invalid(feature):
    return "Invalid" in feature.State


def near(vector, expected):
    return App.Vector(vector).isEqual(App.Vector(*expected), 1e-9)


def test_on_a_face_the_direction_lies_in_it(doc, ball):
    rosette = make_rosette(ball, "Face1", (0, 0, 50), (1, 0, 1))
    assert rosette.Status == "ok" and near(rosette.Origin, (0, 0, 10)) and near(rosette.FirstAxis, (1, 0, 0))
    assert len(rosette.Shape.Edges) == 3 and rosette_of(rosette).origin == pytest.approx((0, 0, 10))
    ball.Radius = 20
    doc.recompute()
    assert near(rosette.Origin, (0, 0, 20))
    rosette.Turn = 90
    doc.recompute()
    assert near(rosette.FirstAxis, (0, 1, 0))
    rosette.setExpression("Turn", "Ball.Radius / 1 mm * 2.25 deg")
    doc.recompute()
    assert near(rosette.FirstAxis, (ROOT, ROOT, 0))
    first, second, normal = (edge.Vertexes[-1].Point - edge.Vertexes[0].Point for edge in rosette.Shape.Edges)
    assert first.normalize().cross(second.normalize()).isEqual(normal.normalize(), 1e-9)


def test_a_direction_that_stands_on_the_face_is_refused(doc, ball):
    rosette = make_rosette(ball, "Face1", (0, 0, 50), (0, 0, 1))
    assert is_invalid(rosette) and "stands on the face" in rosette.Message
    rosette.Direction = App.Vector(0, 0, 0)
    doc.recompute()
    assert is_invalid(rosette) and "is zero" in rosette.Message


def test_on_edges_vertices_and_nothing(doc, plate):
    edge = plate.Shape.Edge2
    along = make_rosette(plate, "Edge2")
    expected = edge.tangentAt(0.5 * (edge.FirstParameter + edge.LastParameter))
    assert near(along.Origin, edge.CenterOfMass) and abs(abs(along.FirstAxis.dot(expected)) - 1) < 1e-12
    assert len(along.Shape.Edges) == 1
    along.Turn = 10
    doc.recompute()
    assert is_invalid(along) and "no normal to turn about" in along.Message
    corner = make_rosette(plate, "Vertex3", direction=(0, 3, 4))
    assert near(corner.Origin, plate.Shape.Vertex3.Point) and near(corner.FirstAxis, (0, 0.6, 0.8))
    free = make_rosette(None, point=(1, 2, 3), direction=(0, 0, 2), doc=doc)
    assert near(free.Origin, (1, 2, 3)) and near(free.FirstAxis, (0, 0, 1))


def test_on_a_coordinate_system_in_a_moved_container(doc):
    part = doc.addObject("App::Part", "Part")
    system = doc.addObject("App::Placement", "System")
    part.addObject(system)
    part.Placement.Base = App.Vector(100, 0, 0)
    system.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(App.Vector(0, 0, 1), 90))
    doc.recompute()
    rosette = make_rosette(system)
    assert near(rosette.Origin, (101, 2, 3)) and near(rosette.FirstAxis, (0, 1, 0))
    part.Placement.Base = App.Vector(0, 50, 0)
    doc.recompute()
    assert near(rosette.Origin, (1, 52, 3)), "it follows the container"
    rosette.Turn = -90
    doc.recompute()
    assert near(rosette.FirstAxis, (1, 0, 0))


def test_a_deleted_or_changed_support_is_told(doc, plate, ball):
    on_edge, on_ball = make_rosette(plate, "Edge4"), make_rosette(ball, "Face1", (0, 0, 9))
    doc.removeObject(ball.Name)
    doc.recompute()
    on_ball.touch()
    doc.recompute()
    assert is_invalid(on_ball) and on_ball.OutOfDate and "is gone" in on_ball.Message
    set_support(on_ball, plate, "Face1")
    doc.recompute()
    assert on_ball.Status == "ok" and not on_ball.OutOfDate
    set_support(on_edge, plate, "Edge77")
    doc.recompute()
    assert is_invalid(on_edge) and "Edge77" in on_edge.Message


def test_plies_count_their_angles_from_it(doc, plate):
    layup = make_layup(doc, layup_from_notation("[0/45/90]", "IM7-8552-134"))
    rosette = make_rosette(plate, "Face1", (50, 30, 0), (0, 1, 0))
    stack = make_ply_stack(plate, "Face1", layup, output=OUTPUTS[1])
    assert all(near(ply.FibreDirection, (0, 0, 0)) for ply in plies_of(stack))
    stack.Rosette = rosette
    doc.recompute()
    doc.recompute()
    directions = [ply.FibreDirection for ply in plies_of(stack)]
    assert near(directions[0], (0, 1, 0)) and near(directions[1], (-ROOT, ROOT, 0)) and near(directions[2], (-1, 0, 0))
    rosette.Turn = -90
    doc.recompute()
    doc.recompute()
    assert near(plies_of(stack)[0].FibreDirection, (1, 0, 0))
    rosette.Direction = App.Vector(0, 0, 1)
    doc.recompute()
    assert is_invalid(rosette)
    with pytest.raises(RuntimeError, match=rosette.Label):
        stack.Proxy.execute(stack)  # FreeCAD does not recompute what depends on an invalid object


def test_rows_name_rosettes_by_label(doc, plate):
    own, other = make_rosette(plate, "Face1", (1, 1, 0)), make_rosette(plate, "Face1", (9, 9, 0), (0, 1, 0))
    other.Label = "Flange"
    layup = make_layup(doc)
    set_layup(layup, Layup((Ply("P1", "A", 0.2, 0.0), Ply("P2", "A", 0.2, 0.0, rosette="Flange"))))
    doc.recompute()
    stack = make_ply_stack(plate, "Face1", layup, output=OUTPUTS[1])
    stack.Rosette = own
    doc.recompute()
    doc.recompute()
    assert stack.Rosettes == [other] and set(rosettes_of(stack)) == {"", "Flange"} and rosette_for_all(stack) is None
    assert [tuple(ply.FibreDirection) for ply in plies_of(stack)] == [(1, 0, 0), (0, 1, 0)]
    set_layup(layup, Layup((Ply("P1", "A", 0.2, 0.0, rosette="Flange"),)))
    doc.recompute()
    link_rosettes(stack)
    assert rosette_for_all(stack).direction == pytest.approx((0, 1, 0))


def test_rows_that_name_no_rosette_of_the_document_are_told(doc, plate, tmp_path):
    layup = make_layup(doc)
    set_layup(layup, Layup((Ply("P1", "A", 0.2, 0.0, rosette="Flange"),)))
    doc.recompute()
    stack = make_ply_stack(plate, "Face1", layup, output=OUTPUTS[1])
    told = "Fibre directions are unknown where rows name 'Flange': make a rosette with that label."
    assert stack.Status == "ok" and stack.Warnings == [told] and near(plies_of(stack)[0].FibreDirection, (0, 0, 0))
    for name in ("book.html", "section.inp", "layup.h5"):
        with pytest.raises(
            ValueError, match="'Flange' in the column Rosette; make a rosette with that label"
        ) as refused:
            ExportStackCommand.create(stack, str(tmp_path / name))
        assert "rosette=" not in str(refused.value) and not (tmp_path / name).exists()
    make_rosette(plate, "Face1", (1, 1, 0), (0, 1, 0)).Label = "Flange"
    link_rosettes(stack)
    doc.recompute()
    doc.recompute()
    assert stack.Warnings == [] and near(plies_of(stack)[0].FibreDirection, (0, 1, 0))
    ExportStackCommand.create(stack, str(tmp_path / "layup.h5"))
    set_layup(layup, Layup((Ply("P1", "A", 0.2, 0.0, rosette="Flange"), Ply("P2", "A", 0.2))))
    doc.recompute()
    with pytest.raises(
        ValueError, match="others none; choose a Rosette in the stack's panel for the others"
    ) as refused:
        ExportStackCommand.create(stack, str(tmp_path / "more.h5"))
    assert "rosette=" not in str(refused.value) and not (tmp_path / "more.h5").exists()


def test_exports_take_its_axes(doc, plate, tmp_path):
    layup = make_layup(doc, layup_from_notation("[0/90]", "IM7-8552-134"))
    stack = make_ply_stack(plate, "Face1", layup)
    path = tmp_path / "section.inp"
    ExportStackCommand.create(stack, str(path))
    usual = path.read_text(encoding="utf-8")
    stack.Rosette = make_rosette(plate, "Face1", (50, 30, 0), (3, 4, 0))
    doc.recompute()
    ExportStackCommand.create(stack, str(path))
    turned = path.read_text(encoding="utf-8")
    assert turned != usual and "0.6" in turned and "0.8" in turned


def test_it_is_saved_restored_and_copied(doc, plate, tmp_path):
    rosette = make_rosette(plate, "Face1", (50, 30, 0), (0, 1, 0))
    stack = make_ply_stack(plate, "Face1", make_layup(doc))
    stack.Rosette = rosette
    doc.recompute()
    path = str(tmp_path / "rosette.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        again = reopened.Rosette
        assert near(again.FirstAxis, (0, 1, 0)) and reopened.PlyStack.Rosette == again and again.Status == "ok"
        twin = reopened.copyObject(again, False)
        twin.Direction = App.Vector(1, 0, 0)
        reopened.recompute()
        assert near(twin.FirstAxis, (1, 0, 0)) and near(again.FirstAxis, (0, 1, 0))
    finally:
        App.closeDocument(reopened.Name)


def test_in_a_container_of_its_own_it_stays_where_its_face_is(doc, plate):
    inside = doc.addObject("App::Part", "Inside")
    inside.Placement = App.Placement(App.Vector(100, 5, 0), App.Rotation(App.Vector(0, 0, 1), 90))
    rosette = make_rosette(plate, "Face1", (50, 30, 0))
    inside.addObject(rosette)
    rosette.touch()
    doc.recompute()
    start = rosette.Shape.Edges[0].Vertexes[0].Point
    assert near(inside.Placement.multVec(start), (50, 30, 0)) and near(rosette.Origin, (50, 30, 0))
    assert Part.Vertex(rosette.Origin).distToShape(plate.Shape)[0] < 1e-9
