# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rosette is picked on a face and turned; a stack counts its angles from it, and a ply of the table from another one."""

import FreeCAD as App
import FreeCADGui as Gui
from models import only, wavy_document
from PySide import QtCore, QtGui
from session import (
    QTest,
    cell,
    click_in_view,
    edit,
    press,
    pump,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    select,
    type_into,
    widget,
    words_in,
)

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc, base = wavy_document(1280, 720)
    rosette = picked(doc, base)
    stack = used(doc, base, rosette)
    named_in_the_table(doc, base, stack)
    undone(doc, stack)


def picked(doc, base):
    """With nothing selected the panel asks for a place; a click on the face gives it."""
    Gui.Selection.clearSelection()
    run_command("LaminateOffset_Rosette")
    assert "Click a face" in result_text()
    place = base.Shape.Face1.valueAt(0.4, 0.6)
    click_in_view(point=place)
    rosette = only(doc, "Rosette")
    assert rosette.Status == "ok" and rosette.Origin.distanceToPoint(rosette.Point) < 0.1, result_text()
    assert rosette.Origin.distanceToPoint(place) < 15
    assert widget("support", QtGui.QLabel).text() == "Wavy: Face1" and words_in(rosette) == [" Rosette"]
    before = App.Vector(rosette.FirstAxis)
    type_into("turn", "30 deg")
    assert abs(before.getAngle(rosette.FirstAxis) - 0.5235987756) < 1e-6
    choice = widget("direction", QtGui.QComboBox)
    choice.setFocus()
    for _ in range(2):
        QTest.keyClick(choice, QtCore.Qt.Key_Down)
    pump(200)
    assert rosette.Direction == App.Vector(0, 0, 1) and rosette.Status == "ok"
    for _ in range(2):
        QTest.keyClick(choice, QtCore.Qt.Key_Up)
    pump(200)
    assert rosette.Direction == App.Vector(1, 0, 0)
    screenshot("rosette")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and rosette.Turn.Value == 30
    assert len(set(rosette.ViewObject.LineColorArray)) == 3
    return rosette


def used(doc, base, rosette):
    """A new stack takes the document's only rosette; its panel offers the others."""
    from laminate_offset.features.layup import make_layup

    make_layup(doc)
    select(base, "Face1")
    run_command("LaminateOffset_PlyStack")
    box = widget("rosette", QtGui.QComboBox)
    assert [box.itemText(row) for row in range(box.count())] == [
        "none: an axis of the model",
        "Rosette",
    ] and box.currentIndex() == 1
    widget("output", QtGui.QComboBox).setCurrentText("Named plies")
    screenshot("stack_panel")
    press(BUTTON.Ok)
    stack = only(doc, "PlyStack")
    (ply,) = stack.ViewObject.Proxy.claimChildren()
    assert stack.Rosette == rosette and ply.FibreDirection.getAngle(rosette.FirstAxis) < 1e-9
    return stack


def named_in_the_table(doc, base, stack) -> None:
    """A row of the table names another rosette, which the table offers; the stack of the layup follows."""
    from laminate_offset.features.rosette import make_rosette

    flange = make_rosette(base, "Face1", (90, 20, 0), (0, 1, 0))
    flange.Label = "Flange"
    edit(stack.Layup)
    tree = widget("rows", QtGui.QTreeWidget)
    box = tree.itemDelegateForColumn(6).createEditor(tree.viewport(), None, None)
    assert [box.itemText(row) for row in range(box.count())] == ["Rosette", "Flange"]
    box.deleteLater()
    cell(0, 6, "Flange")
    screenshot("table")
    press(BUTTON.Ok)
    (ply,) = stack.ViewObject.Proxy.claimChildren()
    assert stack.Rosettes == [flange] and ply.FibreDirection.getAngle(flange.FirstAxis) < 1e-9
    doc.undo()
    assert stack.Rosettes == [] and ply.FibreDirection.getAngle(stack.Rosette.FirstAxis) < 1e-9
    doc.removeObject(flange.Name)


def undone(doc, stack) -> None:
    """An edit is one step of undo; Cancel takes it back; an edge gives its own direction."""
    rosette = only(doc, "Rosette")
    edit(rosette)
    type_into("turn", "75 deg")
    press(BUTTON.Cancel)
    assert rosette.Turn.Value == 30
    select(only(doc, "Wavy"), "Edge2")
    run_command("LaminateOffset_Rosette")
    assert "Edge2" in widget("support", QtGui.QLabel).text() and not result_is_red()
    type_into("turn", "5 deg")
    assert result_is_red() and "no normal to turn about" in result_text()
    press(BUTTON.Cancel)
    assert len([obj for obj in doc.Objects if obj.Name.startswith("Rosette")]) == 1
    doc.undo()
    assert doc.getObject("PlyStack") is None and stack is not None
