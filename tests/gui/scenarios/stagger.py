# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ends of plies are staggered in the panel: wrong lists are told there, right ones are kept, shown again and undone."""

import math

import FreeCAD as App
import FreeCADGui as Gui
from laminate_offset.features.layup import make_layup, set_layup
from laminate_offset.features.ply_stack import make_ply_stack, result_of
from laminate_offset.layup import Layup, Ply
from PySide import QtCore, QtGui
from session import (
    QTest,
    click,
    edit,
    look_at_all,
    press,
    pump,
    result_is_red,
    result_text,
    screenshot,
    start,
    widget,
)

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1280, 720)
    stack = stack_with_patches(doc)
    look_at_all()
    edit(stack)
    assert field().text() == "" and radii(stack) == [20, 20]
    wrong_lists_are_told(stack)
    type_list("Patch=0, 5 mm")
    click("preview")
    assert not result_is_red() and radii(stack) == [20, 15], result_text()
    screenshot("stagger")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and stack.Stagger == ["Patch=0, 5 mm"]
    edit(stack)
    assert field().text() == "Patch=0, 5 mm"
    type_list("2, 8")
    press(BUTTON.Cancel)
    assert stack.Stagger == ["Patch=0, 5 mm"] and radii(stack) == [20, 15]
    doc.undo()
    doc.recompute()
    assert stack.Stagger == [] and radii(stack) == [20, 20]
    doc.redo()
    doc.recompute()
    assert radii(stack) == [20, 15]


def stack_with_patches(doc):
    """A ply on a whole plane, and two on a circle of radius 20."""
    plane, circle = doc.addObject("Part::Plane", "Plane"), doc.addObject("Part::Circle", "Circle")
    plane.Length = plane.Width = 100
    circle.Label, circle.Radius = "Patch", 20
    circle.Placement.Base = App.Vector(50, 50, 0)
    doc.recompute()
    layup = make_layup(doc)
    patches = [Ply(name, "A", 0.2, boundary="Patch") for name in ("P2", "P3")]
    set_layup(layup, Layup((Ply("P1", "A", 0.2), *patches)))
    doc.recompute()
    return make_ply_stack(plane, "Face1", layup)


def wrong_lists_are_told(stack) -> None:
    """Each is red, with what is wrong; the last good stack is kept."""
    for text, told in (
        ("Patch=0; 5", "not of the form"),
        ("Patch=0, five", "no list of distances"),
        ("Patch=0", "which has 2 plies"),
        ("Edge=0,5", "use one of Patch"),
    ):
        type_list(text)
        click("preview")
        assert result_is_red() and told in result_text(), result_text()
        assert stack.OutOfDate and len(stack.Shape.Faces) == 3
        line = widget("result", QtGui.QLabel)
        assert line.visibleRegion().boundingRect().height() >= line.height() - 2, "the refusal is out of sight"
    screenshot("wrong_stagger")


def field():
    """The panel's line."""
    return widget("stagger", QtGui.QLineEdit)


def type_list(text: str) -> None:
    """Replaces the line's text and leaves the line."""
    field().setFocus()
    field().selectAll()
    QTest.keyClicks(field(), text)
    QTest.keyClick(field(), QtCore.Qt.Key_Tab)
    pump(200)


def radii(stack):
    """Of the circles that the plies on the patch cover, from their areas."""
    plies = result_of(stack).plies[1:]
    return [round((ply.base_face.Area / math.pi) ** 0.5, 3) for ply in plies]
