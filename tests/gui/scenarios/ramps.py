# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plies that end along an open line: their side, and length and slope of the ramps, in the panel. Warnings are in sight."""

import FreeCADGui as Gui
from fitting import assert_result_in_sight, fits
from laminate_offset.features.ply_stack import result_of
from laminate_offset.layup import Layup, Ply
from models import hide_docks, plate_stack
from PySide import QtGui
from session import (
    click,
    edit,
    press,
    result_is_orange,
    result_is_red,
    result_text,
    screenshot,
    start,
    type_into,
    widget,
)

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1280, 720)
    hide_docks()
    stack = halved(doc)
    edit(stack)
    sides(stack)
    ramps(stack)
    warning(stack)
    broken_expression(stack)
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog()
    shown_again(stack)
    doc.undo()
    doc.recompute()
    assert stack.Sides == [] and (stack.RampLength.Value, stack.RampSlope) == (0, "mean") and stack.Warnings == []


def halved(doc):
    """Two plies of 0.5 mm beside a line along y at x = 50, under one on the whole plane."""
    line = doc.addObject("Part::Line", "Line")
    line.Label = "Edge"
    (line.X1, line.Y1, line.Z1), (line.X2, line.Y2, line.Z2) = (50, -10, 0), (50, 110, 0)
    doc.recompute()
    halves = [Ply(name, "A", 0.5, boundary="Edge") for name in ("P1", "P2")]
    return plate_stack(doc, Layup((*halves, Ply("P3", "A", 0.5))), line)


def sides(stack) -> None:
    """An open line has no inside: the panel asks for the side in its own words, and takes it."""
    click("preview")
    assert result_is_red() and "give its label left or right in Sides" in result_text(), result_text()
    assert_result_in_sight()
    for text, place in (("Edge = right", 75), ("Edge=left", 25)):
        type_into("sides", text)
        type_into("stagger", "0, 20")
        click("preview")
        region = result_of(stack).plies[0].base_face
        assert stack.Status == "ok" and abs(region.CenterOfMass.x - place) < 0.01, result_text()


def ramps(stack) -> None:
    """The length of a ramp takes the place of the drop-off; the steepest slope makes it longer."""
    length = lambda: result_of(stack).plies[0].ramp["length"]
    assert abs(length() - 10) < 1e-6
    type_into("rampLength", "12 mm")
    click("preview")
    assert abs(length() - 12) < 1e-6, result_text()
    widget("rampSlope", QtGui.QComboBox).setCurrentText("steepest")
    click("preview")
    assert stack.RampSlope == "steepest" and 13 < length() < 20, (length(), result_text())
    assert not result_is_orange() and not result_is_red()
    screenshot("ramps")


def warning(stack) -> None:
    """Plies that end along one line: right, but steep. The panel has scrolled to it, at the end and wherever one has been."""
    type_into("stagger", "")
    click("preview")
    assert stack.Status == "ok" and len(stack.Warnings) == 1 and result_is_orange(), result_text()
    assert "P1 and P2 end along one line" in result_text() and not result_is_red()
    assert_result_in_sight()
    fits("warning")


def broken_expression(stack) -> None:
    """FreeCAD does not recompute what has an expression without a value: the panel tells it, and OK does not close."""
    sheet = stack.Document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "12")
    sheet.setAlias("A1", "ramp")
    sheet.recompute()
    stack.setExpression("RampLength", "<<Sheet>>.ramp * 1 mm")
    sheet.clear("A1")
    for tried in (lambda: click("preview"), lambda: press(BUTTON.Ok)):
        tried()
        assert result_is_red() and "'ramp' not found" in result_text() and Gui.Control.activeDialog(), result_text()
        assert_result_in_sight()
    stack.setExpression("RampLength", None)
    stack.Document.removeObject("Sheet")
    click("preview")
    assert stack.RampLength.Value == 12 and result_is_orange(), result_text()


def shown_again(stack) -> None:
    """What was typed is in the panel's lines, and Cancel takes back what is typed there."""
    edit(stack)
    assert widget("sides", QtGui.QLineEdit).text() == "Edge=left"
    assert widget("rampLength").property("rawValue") == 12
    assert widget("rampSlope", QtGui.QComboBox).currentText() == "steepest" and result_is_orange()
    assert_result_in_sight()
    type_into("sides", "Edge=right")
    type_into("rampLength", "0 mm")
    press(BUTTON.Cancel)
    assert stack.Sides == ["Edge=left"] and stack.RampLength.Value == 12
