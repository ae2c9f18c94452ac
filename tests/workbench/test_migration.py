# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of older versions of the objects open in the current one.

data/first_version.FCStd was saved by the first version (commit 636d6c0): a sphere's offset with an expression, two faces
of a cylinder, a free-form face, and a refused offset.
"""

import pathlib
import shutil

import FreeCAD as App
import pytest
from laminate_offset.features.offset_face import OffsetFaceFeature, make_offset_face
from shapes import largest_deviation

DATA = pathlib.Path(__file__).resolve().parent / "data"


@pytest.fixture
def first(tmp_path):
    """The document of the first version, from a copy."""
    path = tmp_path / "first.FCStd"
    shutil.copy(DATA / "first_version.FCStd", path)
    document = App.openDocument(str(path))
    yield document
    App.closeDocument(document.Name)


def test_the_file_is_of_the_first_version():
    import zipfile

    text = zipfile.ZipFile(DATA / "first_version.FCStd").read("Document.xml").decode("utf-8")
    assert "SchemaVersion" not in text.split("<ObjectData", 1)[1] and "SampledEdgeError" not in text
    assert text.count('App::PropertyLinkSub"') == 4


def test_objects_have_todays_properties_and_kept_their_values(first):
    names = ["OfBall", "OfCan", "OfWavy", "Refused"]
    for name in names:
        offset = first.getObject(name)
        assert offset.SchemaVersion == OffsetFaceFeature.SCHEMA == 2
        assert offset.getTypeIdOfProperty("Base") == "App::PropertyLinkSubList"
    of_ball, of_can, of_wavy, refused = (first.getObject(name) for name in names)
    assert of_ball.Base == [(first.Ball, ("Face1",))] and of_ball.FaceCount == 1
    assert of_can.Base == [(first.Can, ("Face2", "Face1"))] and of_can.FaceCount == 2
    assert of_wavy.Tolerance.Value == pytest.approx(1e-2) and of_wavy.Shape.isValid()
    assert dict(of_ball.ExpressionEngine) == {"Distance": "Ball.Radius / 5"}
    assert refused.Shape.isNull() and refused.Status == "curvature-limit" and not refused.OutOfDate


def test_objects_live_on(first):
    first.Ball.Radius = 20
    first.OfCan.Distance = 2
    first.OfWavy.Distance = -2
    first.recompute()
    assert first.OfBall.Shape.Faces[0].Surface.Radius == pytest.approx(24)
    assert len(first.OfCan.Shape.Faces) == 2 and first.OfCan.Status == "ok"
    assert largest_deviation(first.Wavy.Shape.Face1, first.OfWavy.Shape.Face1, -2) <= 1e-2
    assert first.Refused.Status == "ok" and first.Refused.Shape.Faces[0].Surface.Radius == pytest.approx(5)
    assert all("Invalid" not in obj.State for obj in first.Objects)


def test_an_object_of_a_newer_version_is_left_as_it_is(doc, ball, tmp_path):
    offset = make_offset_face(ball, "Face1", 2)
    offset.SchemaVersion = 99
    path = str(tmp_path / "newer.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        assert reopened.OffsetFace.SchemaVersion == 99 and reopened.OffsetFace.Shape.isValid()
    finally:
        App.closeDocument(reopened.Name)
