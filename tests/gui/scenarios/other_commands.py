# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits, extension and deviation map of a free-form face; which commands are active with which selection."""

import math

import FreeCADGui as Gui
from models import only, wavy_document
from PySide import QtGui
from session import (
    click,
    edit,
    faces,
    look_at_all,
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
NAMES = (
    "OffsetFace ExtendFace OffsetLimits CurvatureMap DeviationMap Layup ImportLayup ExportLayup Rosette PlyStack "
    "CoreSample StackSection ExplodedView ExportStack ExportPlyBook"
).split()
ON_FACES = {"OffsetFace", "ExtendFace", "OffsetLimits", "CurvatureMap", "PlyStack", "Rosette"}
ALWAYS = {"Layup", "ImportLayup"}


def run() -> None:
    """Called by scenario_runner.py."""
    doc, base = wavy_document()
    limits(doc, base)
    extension(doc, base)
    deviation(doc, base)
    activity(doc, base)


def limits(doc, base) -> None:
    """The range is in the panel, both places are on the model."""
    select(base, "Face1")
    run_command("LaminateOffset_OffsetLimits")
    found = only(doc, "OffsetLimits")
    low, high = found.Negative.Value, found.Positive.Value
    assert -30 < low < -15 and 15 < high < 30, (low, high)
    assert widget("negative", QtGui.QLabel).text() == f"{low:.6g} mm"
    assert widget("positive", QtGui.QLabel).text() == f"{high:.6g} mm"
    assert sorted(words_in(found)) == sorted(f"  {limit:.4g} mm" for limit in (low, high)), words_in(found)
    screenshot("limits")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and len(found.Shape.Edges) == 2
    found.ViewObject.Visibility = False
    assert words_in(found) == []


def extension(doc, base) -> None:
    """Two sides are extended; no side is refused in words; Cancel of a later edit takes nothing away."""
    select(base, "Face1")
    run_command("LaminateOffset_ExtendFace")
    type_into("length", "5 mm")
    for name in ("uMin", "uMax", "vMin", "vMax"):
        click(name)
    press(BUTTON.Ok)
    assert Gui.Control.activeDialog() and result_is_red() and "tick at least one" in result_text()
    click("uMax")
    click("vMin")
    click("preview")
    screenshot("extension")
    press(BUTTON.Ok)
    extended = only(doc, "ExtendFace")
    assert extended.Status == "ok" and extended.Shape.isValid() and extended.Shape.Area > 1.1 * base.Shape.Area
    area = extended.Shape.Area
    edit(extended)
    assert faces() == ["Wavy: Face1"]
    type_into("length", "8 mm")
    click("preview")
    assert extended.Shape.Area > area
    press(BUTTON.Cancel)
    assert math.isclose(extended.Shape.Area, area) and extended.Length.Value == 5
    extended.ViewObject.Visibility = False


def deviation(doc, base) -> None:
    """The map lies on the offset, with a legend, and follows the offset."""
    select(base, "Face1")
    run_command()
    type_into("distance", "3 mm")
    press(BUTTON.Ok)
    offset = only(doc, "OffsetFace")
    select(offset, "")
    run_command("LaminateOffset_DeviationMap")
    chart = only(doc, "DeviationMap")
    assert chart.Status == "ok" and len(chart.Deviations) == len(chart.Points) > 2000
    extreme = max(map(abs, chart.Deviations))
    assert 1e-6 < extreme <= offset.Tolerance.Value
    assert "Deviation" in words_in(chart) and f"{extreme:.3g} mm" in words_in(chart), words_in(chart)
    base.ViewObject.Visibility = False
    look_at_all()
    screenshot("deviation")
    edit(chart)
    assert widget("highest", QtGui.QLabel).text() == f"{chart.Highest.Value:.4g} mm"
    type_into("triangles", "9000")
    click("preview")
    assert len(chart.Corners) >= 27000 and "from" in result_text(), result_text()
    screenshot("deviation_panel")
    press(BUTTON.Cancel)
    assert chart.Triangles == 4000
    offset.Tolerance = 0.05
    doc.recompute()
    assert max(map(abs, chart.Deviations)) > extreme
    doc.undo()
    base.ViewObject.Visibility = True


def activity(doc, base) -> None:
    """The toolbar follows the selection."""
    Gui.Selection.clearSelection()
    assert active() == ON_FACES | ALWAYS, active()
    select(base, "Face1")
    assert active() == ON_FACES | ALWAYS, active()
    select(base, "Edge1")
    assert active() == ALWAYS | {"Rosette"}, active()
    select(only(doc, "OffsetFace"), "")
    assert active() == ON_FACES - {"Rosette"} | ALWAYS | {"DeviationMap"}, active()
    run_command("LaminateOffset_Layup")
    assert active() == set()
    press(BUTTON.Ok)
    select(only(doc, "Layup"), "")
    assert active() == ALWAYS | {"ExportLayup", "PlyStack"}, active()


def active() -> set:
    """The enabled buttons of our toolbar."""
    pump(400)
    (bar,) = [b for b in Gui.getMainWindow().findChildren(QtGui.QToolBar) if b.windowTitle() == "Laminate Offset"]
    texts = {
        action.text().replace("&", "").replace(" ", "").replace("...", "")
        for action in bar.actions()
        if action.isEnabled()
    }
    return texts & set(NAMES)
