# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/tutorial.md step by step, with mouse and keys, in a window of 1280 x 720. scripts/tutorial_pictures keeps the
pictures."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import ImportGui
from fitting import fits
from models import hide_docks
from PySide import QtCore, QtGui
from session import (
    OUT,
    QTest,
    cell,
    click,
    click_in_view,
    inside_point,
    look_at_all,
    press,
    pump,
    result_text,
    run_command,
    screenshot,
    shown,
    start,
    wait_until,
    widget,
)

BUTTON = QtGui.QDialogButtonBox
EXAMPLES = os.path.join(os.environ["LAMINATE_OFFSET_BUILD_DIR"], "Mod", "LaminateOffset", "resources", "examples")
#: What the tutorial's table holds: material and angle of the plies.
PLIES = (("AS4-8552S-PW-193", "45"), ("IM7-8552-134", "0"), ("IM7-8552-134", "-45"), ("IM7-8552-134", "90"))


def run() -> None:
    """Called by scenario_runner.py."""
    App.closeDocument(start(1280, 720).Name)
    hide_docks()
    ImportGui.open(os.path.join(EXAMPLES, "panel_two_holes.step"))
    doc = App.ActiveDocument
    (panel,) = [obj for obj in doc.Objects if hasattr(obj, "Shape") and len(obj.Shape.Faces) == 1]
    look_at_all()
    screenshot("1_panel")
    place = inside_point(panel.Shape.Face1)
    click_in_view(point=place)
    limits(doc)
    offset(place)
    layup()
    stack(doc, place)
    sample(doc, place)
    look_closer(doc)
    export(doc)


def finish(button) -> None:
    """OK or Cancel; then the panel is gone."""
    press(button)
    wait_until(lambda: not Gui.Control.activeDialog(), f"the panel to close; it says: {said()}")
    pump(200)


def said() -> str:
    """What the panel's last line says, if there is a panel."""
    labels = shown(QtGui.QLabel, "result")
    return labels[0].text() if labels else ""


def limits(doc) -> None:
    """How far the face can go."""
    run_command("LaminateOffset_OffsetLimits")
    fits("2_limits")
    finish(BUTTON.Ok)
    doc.OffsetLimits.ViewObject.Visibility = False


def offset(place) -> None:
    """A caul surface at 200 mm, with the live preview; Cancel takes it back."""
    click_in_view(point=place)
    run_command()
    click("livePreview")
    line = widget("distance").findChild(QtGui.QLineEdit)
    line.setFocus()
    line.selectAll()
    QTest.keyClicks(line, "200 mm")
    QTest.keyClick(line, QtCore.Qt.Key_Tab)
    wait_until(lambda: "poles" in result_text(), "the preview", 60000)
    fits("3_preview")
    finish(BUTTON.Cancel)


def layup() -> None:
    """Four rows, symmetric: eight plies."""
    Gui.Selection.clearSelection()
    run_command("LaminateOffset_Layup")
    for row, (material, angle) in enumerate(PLIES):
        if row:
            click("add")
        for column, text in ((1, material), (3, angle)):
            if widget("rows").topLevelItem(row).text(column) != text:
                cell(row, column, text)
    click("symmetric")
    low = Gui.getMainWindow().mapToGlobal(Gui.getMainWindow().rect().bottomLeft()).y()
    total = widget("total", QtGui.QLabel)
    assert total.mapToGlobal(total.rect().bottomLeft()).y() < low, "the running total is out of sight"
    assert widget("total", QtGui.QLabel).text() == "8 plies, 1.184 mm", widget("total", QtGui.QLabel).text()
    fits("4_layup")
    finish(BUTTON.Ok)


def stack(doc, place) -> None:
    """The plies as named objects."""
    click_in_view(point=place)
    run_command("LaminateOffset_PlyStack")
    widget("output", QtGui.QComboBox).setCurrentText("Named plies")
    fits("5_stack_panel")
    finish(BUTTON.Ok)
    made = doc.PlyStack
    assert made.Status == "ok" and made.PlyCount == 8, made.Message
    hide(doc, "panel_two_holes")
    for tree in Gui.getMainWindow().findChildren(QtGui.QTreeWidget):
        tree.expandAll()
    pump(300)
    screenshot("6_stack")


def hide(doc, label: str) -> None:
    """Space on an object in the tree."""
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.Name, doc.getObjectsByLabel(label)[0].Name)
    Gui.runCommand("Std_ToggleVisibility", 0)
    Gui.Selection.clearSelection()


def sample(doc, place) -> None:
    """What lies at a point."""
    run_command("LaminateOffset_CoreSample")
    click_in_view(point=place)
    assert widget("plies", QtGui.QTreeWidget).topLevelItemCount() == 8, result_text()
    fits("7_core_sample")
    finish(BUTTON.Ok)


def look_closer(doc) -> None:
    """The cut of the plies by a plane, and the plies apart from each other."""
    Gui.Selection.clearSelection()
    run_command("LaminateOffset_StackSection")
    assert doc.StackSection.PlyCount == 8 and doc.StackSection.ViewObject.Exaggeration > 10, result_text()
    for ply in doc.PlyStack.ViewObject.Proxy.claimChildren():
        ply.ViewObject.Visibility = False
    Gui.ActiveDocument.ActiveView.viewRight()
    Gui.SendMsgToActiveView("ViewFit")
    fits("8_section")
    finish(BUTTON.Ok)
    doc.StackSection.ViewObject.Visibility = False
    Gui.Selection.addSelection(doc.Name, doc.PlyStack.Name)
    pump(200)
    run_command("LaminateOffset_ExplodedView")
    look_at_all()
    assert doc.PlyStack.ViewObject.DisplayMode == "Exploded"
    screenshot("9_exploded")


def export(doc) -> None:
    """STEP with one part a ply, through the file dialog."""
    path = os.path.join(OUT, "plies.step")

    def save() -> None:
        dialog = QtGui.QApplication.activeModalWidget()
        QTest.keyClicks(dialog.findChild(QtGui.QLineEdit, "fileNameEdit"), path)
        dialog.accept()

    Gui.Selection.addSelection(doc.Name, doc.PlyStack.Name)
    pump(200)
    QtCore.QTimer.singleShot(1500, save)
    run_command("LaminateOffset_ExportStack")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    assert all(f"'{name}'" in text for name in ("P1", "P4", "P4.2", "P1.2")), "the plies' names are not in the file"
    Gui.Selection.clearSelection()
