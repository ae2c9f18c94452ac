# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing is selected: the panel asks for a face, which is picked with the mouse in a moved container."""

import math

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui
from session import (
    click,
    click_in_view,
    edit,
    faces,
    look_at_all,
    offsets,
    press,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    start,
    type_into,
    widget,
)

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start()
    part = doc.addObject("App::Part", "Tool")
    box = doc.addObject("Part::Box", "Box")
    part.addObject(box)
    part.Placement = App.Placement(App.Vector(100, 0, 0), App.Rotation(App.Vector(0, 0, 1), 20))
    doc.recompute()
    Gui.Selection.clearSelection()
    run_command()
    asks_for_a_face(doc)
    pick(part)
    keep(doc, part)
    several_objects(doc, part)


def asks_for_a_face(doc) -> None:
    """OK without a face is refused in words; edges and whole objects can not be picked."""
    assert widget("pick").isChecked() and faces() == []
    press(BUTTON.Ok)
    assert Gui.Control.activeDialog() and result_is_red() and "ick a face" in result_text()
    Gui.Selection.addSelection(doc.Name, "Tool", "Box.Edge1")
    assert faces() == []


def pick(part) -> None:
    """A click in the view."""
    look_at_all()
    Gui.ActiveDocument.ActiveView.viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    click_in_view()
    assert faces() == ["Box: Face6"], faces()
    screenshot("picked")


def keep(doc, part) -> None:
    """OK; then the offset follows the container."""
    press(BUTTON.Ok)
    (offset,) = offsets(doc)
    assert offset.Status == "ok" and offset.Base == [(part, ("Box.Face6",))]
    assert offset.Distance.Value == 1 and math.isclose(offset.Shape.BoundBox.ZMin, 11)
    part.Placement.Base.z = 30
    part.Placement = App.Placement(App.Vector(0, 0, 30), App.Rotation())
    doc.recompute()
    centre = offset.Shape.CenterOfMass
    assert centre.distanceToPoint(App.Vector(5, 5, 41)) < 1e-9, centre


def several_objects(doc, part) -> None:
    """Faces of two objects are offset together; one is taken out of the list, and joins it again with Ctrl."""
    ball = doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    before = offsets(doc)
    Gui.Selection.clearSelection()
    for obj, sub in ((part, "Box.Face1"), (ball, "Face1"), (part, "Box.Face6")):
        Gui.Selection.addSelection(doc.Name, obj.Name, sub)
    run_command()
    assert sorted(faces()) == ["Ball: Face1", "Box: Face1", "Box: Face6"]
    type_into("distance", "3")
    widget("faces").setCurrentRow(faces().index("Ball: Face1"))
    click("remove")
    assert sorted(faces()) == ["Box: Face1", "Box: Face6"]
    press(BUTTON.Ok)
    (offset,) = [offset for offset in offsets(doc) if offset not in before]
    assert len(offset.Shape.Faces) == offset.FaceCount == 2 and offset.Status == "ok"
    edit(offset)
    click("pick")
    join_with_ctrl(doc, ball)
    press(BUTTON.Ok)
    assert offset.Status == "ok" and len(offset.Shape.Faces) == 3 and offset.Distance.Value == 3
    assert any(math.isclose(getattr(face.Surface, "Radius", 0), 8) for face in offset.Shape.Faces)


def join_with_ctrl(doc, ball) -> None:
    """Ctrl+click on a further object's face: only the sphere is left to click on."""
    shown = [obj for obj in doc.Objects if obj is not ball and obj.ViewObject.Visibility]
    for obj in shown:
        obj.ViewObject.Visibility = False
    look_at_all()
    click_in_view(QtCore.Qt.ControlModifier, ball.Shape.BoundBox.Center)
    screenshot("joined")
    for obj in shown:
        obj.ViewObject.Visibility = True
    assert faces() == ["Box: Face1", "Box: Face6", "Ball: Face1"], faces()
