# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo, saving, loading and documents of older versions."""

import json
import math
import os
import subprocess
import sys

import FreeCAD as App
import pytest
from laminate_offset.features.offset_face import make_offset_face
from shapes import radius, wavy_face

#: FreeCAD restores objects of Python modules only from its own Mod folders or when the package is already imported.
_REOPEN = """
import json, sys
import FreeCAD as App
import laminate_offset
doc = App.openDocument(sys.argv[1])
offset = doc.getObject("OffsetFace")
told = {"state": list(offset.State), "status": offset.Status, "radius": offset.Shape.Faces[0].Surface.Radius,
        "valid": offset.Shape.isValid(), "proxy": type(offset.Proxy).__name__, "message": offset.Message,
        "sampled": str(offset.SampledError.Value), "distance": offset.Distance.Value}
doc.getObject("Ball").Radius = 20
doc.recompute()
told["radius_after"] = offset.Shape.Faces[0].Surface.Radius
print("TOLD" + json.dumps(told))
"""


def reopen_in_new_process(path):
    done = subprocess.run([sys.executable, "-c", _REOPEN, str(path)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.split("TOLD", 1)[1])


def test_saved_object_lives_on_in_a_new_process(doc, ball, tmp_path):
    offset = make_offset_face(ball, "Face1", -4)
    path = tmp_path / "saved.FCStd"
    doc.saveAs(str(path))
    told = reopen_in_new_process(path)
    assert told["status"] == "ok" and "Invalid" not in told["state"] and told["valid"]
    assert told["proxy"] == "OffsetFaceFeature" and told["message"] == offset.Message
    assert told["distance"] == -4 and told["sampled"] == "nan"
    assert (told["radius"], told["radius_after"]) == (pytest.approx(6), pytest.approx(16))


def test_reloading_gives_the_same_surface_to_the_last_bit(doc, tmp_path):
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    offset = make_offset_face(base, "Face1", 3)
    poles = offset.Shape.Surface.getPoles()
    assert sum(len(row) for row in poles) == offset.Poles > 0
    path = str(tmp_path / "wavy.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        assert reopened.getObject("OffsetFace").Shape.Surface.getPoles() == poles
    finally:
        App.closeDocument(reopened.Name)


def test_refused_object_is_saved_as_refused(doc, ball, tmp_path):
    make_offset_face(ball, "Face1", -15)
    path = str(tmp_path / "refused.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        offset = reopened.getObject("OffsetFace")
        assert offset.Shape.isNull() and offset.Status == "curvature-limit" and "-15 mm" in offset.Message
    finally:
        App.closeDocument(reopened.Name)


def test_document_of_an_older_version_gets_what_it_lacks(doc, ball, tmp_path):
    offset = make_offset_face(ball, "Face1", 2)
    for name in ("MaxDegree", "SampledEdgeError", "Surface"):
        assert offset.removeProperty(name)
    path = str(tmp_path / "old.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        offset = reopened.getObject("OffsetFace")
        assert offset.MaxDegree == 7 and math.isnan(offset.SampledEdgeError.Value)
        offset.Distance = 5
        reopened.recompute()
        assert offset.Status == "ok" and radius(offset) == pytest.approx(15) and offset.Surface == "exact sphere"
    finally:
        App.closeDocument(reopened.Name)


def test_undo_and_redo_of_the_creation(doc, ball):
    doc.openTransaction("Offset Face")
    make_offset_face(ball, "Face1", 2)
    doc.commitTransaction()
    doc.undo()
    assert doc.getObject("OffsetFace") is None and doc.getObject("Ball") is not None
    doc.redo()
    doc.recompute()
    assert radius(doc.getObject("OffsetFace")) == pytest.approx(12)


def test_undo_of_a_change_that_was_refused(doc, ball):
    offset = make_offset_face(ball, "Face1", 2)
    doc.openTransaction("Change")
    offset.Distance = -15
    doc.recompute()
    doc.commitTransaction()
    assert offset.OutOfDate and radius(offset) == pytest.approx(12)
    doc.undo()
    doc.recompute()
    assert offset.Distance.Value == 2 and offset.Status == "ok" and radius(offset) == pytest.approx(12)
    assert not offset.OutOfDate


def test_aborted_transaction_leaves_nothing(doc, ball):
    doc.openTransaction("Offset Face")
    make_offset_face(ball, "Face1", 2)
    doc.abortTransaction()
    assert doc.getObject("OffsetFace") is None


def test_copy_of_the_object_is_independent(doc, ball):
    offset = make_offset_face(ball, "Face1", 2)
    twin = doc.copyObject(offset, False)
    twin.Distance = 5
    doc.recompute()
    assert (radius(offset), radius(twin)) == (pytest.approx(12), pytest.approx(15))


def test_proxy_serves_old_and_new_freecad(ball):
    proxy = make_offset_face(ball, "Face1", 2).Proxy
    assert proxy.dumps() is None and proxy.__getstate__() is None
    assert proxy.loads(None) is None and proxy.__setstate__(None) is None
    assert not os.path.isabs(type(proxy).__module__) and type(proxy).__module__.startswith("laminate_offset.")
