# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole life of one offset: made, undone, redone, edited, saved, reopened."""

import math
import os

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui
from session import (
    COMMAND,
    OUT,
    WORKBENCH,
    click,
    edit,
    faces,
    look_at_all,
    offsets,
    press,
    run_command,
    screenshot,
    select,
    start,
    type_into,
)

BUTTON = QtGui.QDialogButtonBox
RADIUS, HEIGHT = 20.0, 50.0


def run() -> None:
    """Called by scenario_runner.py."""
    check_workbench()
    doc = start()
    check_toolbar_and_menu()
    offset = make(doc)
    undo_and_redo(doc)
    offset = offsets(doc)[0]
    look_at_all()
    screenshot("offset")
    edit_and_cancel(offset)
    edit_and_flip(offset)
    save_and_reopen(doc)


def check_workbench() -> None:
    """The workbench is in the list, with an icon that can be drawn."""
    workbench = Gui.listWorkbenches()[WORKBENCH]
    assert workbench.MenuText == "Laminate Offset"
    for size in (16, 64):
        assert not QtGui.QIcon(workbench.Icon).pixmap(size, size).isNull(), workbench.Icon


def check_toolbar_and_menu() -> None:
    """Toolbar and menu hold the command; its icon is ours."""
    window = Gui.getMainWindow()
    toolbars = [bar for bar in window.findChildren(QtGui.QToolBar) if bar.windowTitle() == "Laminate Offset"]
    assert len(toolbars) == 1 and toolbars[0].isVisible()
    actions = [action for action in toolbars[0].actions() if "Offset Face" in action.text()]
    assert len(actions) == 1 and not actions[0].icon().isNull() and actions[0].isEnabled()
    assert "Laminate Offset" in [action.text().replace("&", "") for action in window.menuBar().actions()]
    assert COMMAND in Gui.listCommands()


def make(doc):
    """Select a face, run the command, type a distance, press OK."""
    base = doc.addObject("Part::Cylinder", "Base")
    base.Radius, base.Height = RADIUS, HEIGHT
    doc.recompute()
    look_at_all()
    select(base, "Face1")
    names = list(doc.UndoNames)
    run_command()
    assert Gui.Control.activeDialog()
    assert faces() == ["Base: Face1"]
    type_into("distance", "3.5")
    type_into("tolerance", "0.0001 mm")
    click("livePreview")
    click("flip")
    click("flip")
    click("preview")
    screenshot("panel")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog()
    (offset,) = offsets(doc)
    check_offset(offset, RADIUS + 3.5)
    assert math.isclose(offset.Tolerance.Value, 1e-4)
    assert list(doc.UndoNames) == ["Offset Face"] + names, doc.UndoNames
    return offset


def check_offset(offset, radius: float) -> None:
    """The offset of a cylinder is the cylinder of the other radius."""
    assert offset.Status == "ok" and "Invalid" not in offset.State
    assert offset.Shape.isValid()
    assert math.isclose(offset.Shape.Faces[0].Surface.Radius, radius, rel_tol=1e-12)
    assert math.isclose(offset.Shape.Area, 2 * math.pi * radius * HEIGHT, rel_tol=1e-9)


def undo_and_redo(doc) -> None:
    """One step back takes all of it, one step forward brings it again."""
    doc.undo()
    assert offsets(doc) == [] and doc.getObject("Base") is not None
    doc.redo()
    (offset,) = offsets(doc)
    check_offset(offset, RADIUS + 3.5)


def edit_and_cancel(offset) -> None:
    """A double click opens the panel; Cancel leaves the object as it was."""
    edit(offset)
    assert Gui.Control.activeDialog() and Gui.ActiveDocument.getInEdit() is not None
    type_into("distance", "9")
    click("preview")
    check_offset(offset, RADIUS + 9)
    press(BUTTON.Cancel)
    assert not Gui.Control.activeDialog() and Gui.ActiveDocument.getInEdit() is None
    check_offset(offset, RADIUS + 3.5)


def edit_and_flip(offset) -> None:
    """Flip offsets to the other side."""
    edit(offset)
    click("flip")
    press(BUTTON.Ok)
    assert offset.Distance.Value == -3.5
    check_offset(offset, RADIUS - 3.5)


def save_and_reopen(doc) -> None:
    """Everything is there again, and still lives."""
    path = os.path.join(OUT, "life.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    (offset,) = offsets(doc)
    check_offset(offset, RADIUS - 3.5)
    assert offset.ViewObject.Transparency > 0
    assert os.path.exists(offset.ViewObject.Proxy.getIcon())
    doc.getObject("Base").Radius = RADIUS + 10
    doc.recompute()
    check_offset(offset, RADIUS + 6.5)
    look_at_all()
    screenshot("reopened")
