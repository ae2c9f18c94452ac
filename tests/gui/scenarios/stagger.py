# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ends of plies are staggered in the panel: wrong lists are told there, right ones are kept, shown again and undone."""

import math

import FreeCAD as App
import FreeCADGui as Gui
from fitting import assert_result_in_sight
from laminate_offset.features.ply_stack import result_of
from laminate_offset.layup import Layup, Ply
from models import plate_stack
from PySide import QtGui
from session import click, edit, press, result_is_red, result_text, screenshot, start, type_into, widget

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1280, 720)
    stack = stack_with_patches(doc)
    edit(stack)
    assert field().text() == "" and radii(stack) == [20, 20]
    wrong_lists_are_told(stack)
    type_into("stagger", "Patch=0, 5 mm")
    click("preview")
    assert not result_is_red() and radii(stack) == [20, 15], result_text()
    screenshot("stagger")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and stack.Stagger == ["Patch=0, 5 mm"]
    edit(stack)
    assert field().text() == "Patch=0, 5 mm"
    type_into("stagger", "2, 8")
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
    circle = doc.addObject("Part::Circle", "Circle")
    circle.Label, circle.Radius = "Patch", 20
    circle.Placement.Base = App.Vector(50, 50, 0)
    doc.recompute()
    patches = [Ply(name, "A", 0.2, boundary="Patch") for name in ("P2", "P3")]
    return plate_stack(doc, Layup((Ply("P1", "A", 0.2), *patches)), circle)


def wrong_lists_are_told(stack) -> None:
    """Each is red, with what is wrong; the last good stack is kept."""
    for text, told in (
        ("Patch=0; 5", "not of the form"),
        ("Patch=0, five", "no list of distances"),
        ("Patch=0", "which has 2 plies"),
        ("Edge=0,5", "use one of Patch"),
    ):
        type_into("stagger", text)
        click("preview")
        assert result_is_red() and told in result_text(), result_text()
        assert stack.OutOfDate and len(stack.Shape.Faces) == 3
        assert_result_in_sight()
    screenshot("wrong_stagger")


def field():
    """The panel's line."""
    return widget("stagger", QtGui.QLineEdit)


def radii(stack):
    """Of the circles that the plies on the patch cover, from their areas."""
    plies = result_of(stack).plies[1:]
    return [round((ply.base_face.Area / math.pi) ** 0.5, 3) for ply in plies]
