# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the parametric offset computes, reports and refuses."""

import json
import math

import FreeCAD as App
import Part
import pytest
from laminate_offset.features import progress
from laminate_offset.features.offset_face import add_offset_face, make_offset_face, set_base
from shapes import largest_deviation, radius, side, wavy_face


def is_invalid(feature):
    return "Invalid" in feature.State


@pytest.mark.parametrize("distance", [-9.5, -4, 0.001, 2.5, 1000])
def test_offset_of_a_sphere_is_the_sphere_of_the_other_radius(ball, distance):
    offset = make_offset_face(ball, "Face1", distance)
    assert offset.Status == "ok" and not is_invalid(offset)
    assert offset.Shape.ShapeType == "Face" and offset.Shape.isValid()
    assert radius(offset) == pytest.approx(10 + distance, rel=1e-12)
    assert offset.CertifiedError.Value < 1e-9
    assert offset.Surface == "exact sphere" and offset.Poles == 0 and offset.Degree == 0


@pytest.mark.parametrize("distance", [-3.0, 3.0])
def test_free_form_offset_keeps_its_distance(doc, distance):
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    offset = make_offset_face(base, "Face1", distance, tolerance=1e-3)
    assert offset.Status == "ok" and offset.Shape.isValid()
    assert offset.Shape.Surface.TypeId == "Part::GeomBSplineSurface"
    assert largest_deviation(base.Shape.Face1, offset.Shape.Face1, distance) <= 1e-3
    assert side(base.Shape.Face1, offset.Shape.Face1) == math.copysign(1, distance)
    surface = offset.Shape.Surface
    assert offset.Poles == surface.NbUPoles * surface.NbVPoles > 0
    assert offset.Degree == max(surface.UDegree, surface.VDegree)


def test_reversed_face_turns_the_side(doc):
    base = doc.addObject("Part::Feature", "Reversed")
    base.Shape = wavy_face().reversed()
    offset = make_offset_face(base, "Face1", 3)
    assert offset.Status == "ok"
    assert side(base.Shape.Face1, offset.Shape.Face1) == 1
    assert side(wavy_face(), offset.Shape.Face1) == -1


def test_max_degree_and_tolerance_reach_the_engine(doc):
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    offset = make_offset_face(base, "Face1", 3, tolerance=1e-1)
    coarse = offset.Poles
    offset.Tolerance = 1e-5
    doc.recompute()
    assert offset.Status == "ok" and offset.Poles > coarse
    offset.MaxDegree = 3
    doc.recompute()
    assert offset.Status == "ok" and offset.Degree <= 3


def test_a_creased_face_becomes_a_shell_where_the_base_stands(doc):
    roof = Part.BSplineSurface()
    poles = [[App.Vector(x, y, -abs(y)) for y in (-20, 0, 20)] for x in (0, 50)]
    roof.buildFromPolesMultsKnots(poles, [2, 2], [2, 1, 2], [0, 1], [0, 0.5, 1], False, False, 1, 1)
    base = doc.addObject("Part::Feature", "Roof")
    base.Shape = roof.toShape()
    offset = make_offset_face(base, "Face1", 2)
    assert offset.Status == "ok" and offset.Shape.ShapeType == "Shell"
    assert len(offset.Shape.Faces) == 2 and all(face.isValid() for face in offset.Shape.Faces)
    assert "2 faces along creases" in offset.Message and not math.isnan(offset.CertifiedError.Value)
    top = offset.Shape.BoundBox.ZMax
    base.Placement.Base = App.Vector(0, 0, 100)
    doc.recompute()
    assert offset.Status == "ok" and offset.Shape.BoundBox.ZMax == pytest.approx(top + 100)


def test_offset_follows_its_base(doc, ball):
    offset = make_offset_face(ball, "Face1", 2)
    ball.Radius = 25
    doc.recompute()
    assert radius(offset) == pytest.approx(27, rel=1e-12)


def test_offset_of_an_offset(doc, ball):
    first = make_offset_face(ball, "Face1", 2)
    second = make_offset_face(first, "Face1", 3)
    ball.Radius = 20
    doc.recompute()
    assert (radius(first), radius(second)) == (pytest.approx(22), pytest.approx(25))


def test_several_faces_make_a_compound(doc):
    can = doc.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 10, 30
    doc.recompute()
    offset = make_offset_face(can, ["Face1", "Face2", "Face3"], 2)
    assert offset.Status == "ok" and offset.Shape.ShapeType == "Compound"
    wall, *ends = offset.Shape.Faces
    assert wall.Surface.Radius == pytest.approx(12)
    # The bases are at z = 0 and 30, whichever FreeCAD counts first.
    bases = [face.CenterOfMass.z for face in can.Shape.Faces[1:]]
    assert [face.CenterOfMass.z for face in ends] == [pytest.approx(-2 if z < 15 else 32) for z in bases]
    reports = json.loads(offset.ReportJson)
    assert [report["surface"]["type"] for report in reports] == ["cylinder", "plane", "plane"]
    assert offset.CertifiedError.Value == max(report["certified_error"] for report in reports)


def test_distance_takes_an_expression(doc, ball):
    offset = make_offset_face(ball, "Face1", 1)
    offset.setExpression("Distance", "Ball.Radius / 4")
    doc.recompute()
    assert radius(offset) == pytest.approx(12.5)
    ball.Radius = 20
    doc.recompute()
    assert radius(offset) == pytest.approx(25)


def test_refused_distance_keeps_the_last_good_shape_and_says_why(doc, ball):
    offset = make_offset_face(ball, "Face1", -4)
    assert radius(offset) == pytest.approx(6) and not offset.OutOfDate and offset.RefusedAt == []
    offset.Distance = -15
    doc.recompute()
    assert is_invalid(offset) and offset.OutOfDate and radius(offset) == pytest.approx(6)
    assert offset.Status == "curvature-limit" and len(offset.RefusedAt) == 1
    assert "Face1" in offset.Message and "-15 mm" in offset.Message and "-10 mm" in offset.Message
    assert offset.getStatusString() == offset.Message
    assert "-10 mm" in offset.Limits
    (report,) = json.loads(offset.ReportJson)
    assert report["status"] == "curvature-limit" and report["stage"] == "analysis"
    assert report["limits"]["negative"] == pytest.approx(-10)
    for name in ("CertifiedError", "SampledError", "EdgeError", "SampledEdgeError"):
        assert math.isnan(getattr(offset, name).Value), f"{name} of the last success is left over"
    assert offset.Poles == 0 and offset.Surface == ""
    offset.Distance = -5
    doc.recompute()
    assert not is_invalid(offset) and not offset.OutOfDate and offset.RefusedAt == []
    assert radius(offset) == pytest.approx(5)


def test_first_refusal_leaves_the_shape_empty(ball):
    offset = make_offset_face(ball, "Face1", -15)
    assert is_invalid(offset) and offset.Shape.isNull() and not offset.OutOfDate


def test_refused_object_recovers(doc, ball):
    offset = make_offset_face(ball, "Face1", -15)
    assert is_invalid(offset)
    ball.Radius = 20
    doc.recompute()
    assert not is_invalid(offset) and offset.Status == "ok" and radius(offset) == pytest.approx(5)


def test_one_refused_face_refuses_the_object(doc):
    can = doc.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 10, 30
    doc.recompute()
    offset = make_offset_face(can, ["Face2", "Face1"], -12)
    assert is_invalid(offset) and offset.Shape.isNull() and offset.Status == "curvature-limit"
    assert offset.Message.startswith("Face1:")


def test_bad_tolerance_is_refused(doc, ball):
    offset = make_offset_face(ball, "Face1", 1, tolerance=0)
    assert is_invalid(offset) and offset.Shape.isNull() and offset.Status == "invalid-option"
    assert "tolerance" in offset.Message
    assert json.loads(offset.ReportJson)[0]["stage"] == "options"


@pytest.mark.parametrize("sub", ["Face99", "Face"])
def test_missing_face_is_named(doc, ball, sub):
    offset = make_offset_face(ball, sub, 1)
    assert is_invalid(offset) and offset.Shape.isNull() and offset.Status == "null-shape"
    assert sub in offset.Message and "Ball" in offset.Message and "pick the face again" in offset.Message


def test_edge_is_not_a_face(doc, ball):
    offset = make_offset_face(ball, "Edge1", 1)
    assert is_invalid(offset) and offset.Status == "not-a-face" and "Edge1" in offset.Message


def test_face_that_vanishes_refuses(doc):
    base = doc.addObject("Part::Feature", "Base")
    base.Shape = Part.makeBox(1, 2, 3)
    offset = make_offset_face(base, "Face6", 1)
    assert offset.Status == "ok"
    base.Shape = Part.makeSphere(5)
    doc.recompute()
    assert is_invalid(offset) and offset.OutOfDate and offset.Status == "null-shape"


def test_no_base_is_refused(doc):
    offset = add_offset_face(doc)
    doc.recompute()
    assert is_invalid(offset) and offset.Status == "null-shape" and "pick a face" in offset.Message


def test_deleted_base_is_refused(doc, ball):
    offset = make_offset_face(ball, "Face1", 1)
    doc.removeObject(ball.Name)
    offset.touch()
    doc.recompute()
    assert is_invalid(offset) and offset.OutOfDate and offset.Status == "null-shape"


def test_faces_of_several_objects_and_one_of_them_deleted(doc, ball):
    can = doc.addObject("Part::Cylinder", "Can")
    can.Radius, can.Height = 10, 30
    doc.recompute()
    offset = add_offset_face(doc)
    set_base(offset, [(ball, ["Face1"]), (can, ["Face1", "Face2"]), (ball, ["Face1"])])
    offset.Distance = 2
    doc.recompute()
    assert offset.Status == "ok" and len(offset.Shape.Faces) == offset.FaceCount == 3
    assert offset.Shape.Faces[0].Surface.Radius == pytest.approx(12)
    offset.Distance = -12
    doc.recompute()
    assert is_invalid(offset) and offset.Message.startswith("Ball: Face1: ")
    offset.Distance = 2
    doc.removeObject(can.Name)
    doc.recompute()
    assert is_invalid(offset) and offset.OutOfDate, "a face less must not go unnoticed"
    assert "2 of 3 base faces are gone" in offset.Message and "pick" in offset.Message
    set_base(offset, [(ball, ["Face1"])])
    doc.recompute()
    assert offset.Status == "ok" and len(offset.Shape.Faces) == 1


def test_progress_is_told_and_can_cancel(doc):
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    told = []

    def watcher(title, work):
        told.append(title)

        def report(fraction):
            told.append(fraction)
            return False

        try:
            return work(report)
        finally:
            told.append("end")

    progress.install(watcher)
    try:
        offset = make_offset_face(base, "Face1", 3)
    finally:
        progress.install(None)
    assert told[0] == "OffsetFace" and told[-1] == "end" and len(told) > 2
    assert all(0 <= fraction <= 1 for fraction in told[1:-1])
    assert is_invalid(offset) and offset.Status == "cancelled" and offset.Shape.isNull()


def test_properties_are_documented_and_typed(ball):
    offset = make_offset_face(ball, "Face1", 1)
    types = {name: offset.getTypeIdOfProperty(name) for name in offset.PropertiesList}
    assert types["Base"] == "App::PropertyLinkSubList"
    assert types["Distance"] == "App::PropertyDistance" and types["Tolerance"] == "App::PropertyLength"
    assert offset.getEnumerationsOfProperty("Method") == ["same-parameter", "ravi-kumar"]
    own = [name for name in offset.PropertiesList if offset.getGroupOfProperty(name) in ("Offset", "Report")]
    assert len(own) >= 15
    for name in own:
        assert offset.getDocumentationOfProperty(name), f"{name} has no description"
    for name in ("Status", "Message", "CertifiedError", "SampledError", "EdgeError", "Poles", "Degree", "Placement"):
        assert "ReadOnly" in offset.getEditorMode(name), f"{name} can be edited"


def test_make_offset_face_takes_document_and_name(doc, ball):
    other = App.newDocument("Other")
    try:
        box = other.addObject("Part::Box", "Box")
        other.recompute()
        offset = make_offset_face(box, "Face6", 1, doc=other, name="Top")
        assert offset.Name == "Top" and offset.Document.Name == other.Name
        assert offset.Shape.CenterOfMass.z == pytest.approx(11)
    finally:
        App.closeDocument(other.Name)
