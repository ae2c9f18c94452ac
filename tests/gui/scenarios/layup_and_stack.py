# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole layup is typed into the table, stacked on a face, sampled, changed, saved and opened again."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui
from dragging import drag_row
from session import (
    OUT,
    QTest,
    cell,
    click,
    click_in_view,
    edit,
    inside_point,
    look_at_all,
    press,
    pump,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    select,
    start,
    type_into,
    widget,
)

BUTTON = QtGui.QDialogButtonBox
DRAGGED = QtCore.Qt.ItemIsDragEnabled
PANEL = os.path.join(
    os.environ["LAMINATE_OFFSET_BUILD_DIR"], "Mod", "LaminateOffset", "resources", "examples", "panel_two_holes.step"
)
#: name, material, thickness, angle of the rows that are typed.
ROWS = [("P1", "AS4-8552S-PW-193", "", "45"), ("P2", "IM7-8552-134", "", "0"), ("P3", "IM7-8552-134", "0.125", "-45")]


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1280, 720)
    base = doc.addObject("Part::Feature", "Tool")
    base.Shape = Part.read(PANEL).Faces[0]
    doc.recompute()
    look_at_all()
    layup = type_layup(doc)
    wrong_cell_is_marked(layup)
    rows_are_moved(layup)
    stack = make_stack(doc, base, layup)
    children(doc, stack)
    sample(doc, stack)
    ply_book(stack)
    undo_redo_and_reopen(doc)


def type_layup(doc):
    """The command, the rows by mouse and keys, symmetric, OK."""
    run_command("LaminateOffset_Layup")
    for row, texts in enumerate(ROWS):
        if row:
            click("add")
        for column, text in enumerate(texts):
            if widget("rows").topLevelItem(row).text(column) != text:
                cell(row, column, text)
    click("symmetric")
    assert widget("total", QtGui.QLabel).text() == "6 plies, 0.91 mm", widget("total", QtGui.QLabel).text()
    screenshot("table")
    press(BUTTON.Ok)
    (layup,) = [obj for obj in doc.Objects if obj.Name.startswith("Layup")]
    assert not Gui.Control.activeDialog() and layup.PlyCount == 6 and layup.Symmetric
    assert layup.Notation == "[45/0/-45]s", layup.Notation
    return layup


def wrong_cell_is_marked(layup) -> None:
    """A wrong cell is red with what is expected; OK waits; Cancel leaves the layup as it was."""
    edit(layup)
    cell(1, 3, "4S")
    item = widget("rows").topLevelItem(1)
    assert item.foreground(3).color().red() > 200 and "degrees" in item.toolTip(3)
    title = widget("rows", QtGui.QTreeWidget).headerItem().text(3)
    assert (
        result_is_red() and f"ply 2, {title}: found '4S', expected a number of degrees" in result_text()
    ), result_text()
    assert title == "Angle" and "angle_deg" not in result_text()
    screenshot("wrong_cell")
    press(BUTTON.Ok)
    assert Gui.Control.activeDialog(), "a wrong table must not be kept"
    press(BUTTON.Cancel)
    assert layup.PlyCount == 6 and layup.Notation == "[45/0/-45]s"


def rows_are_moved(layup) -> None:
    """Duplicate, mirror, angle preset, move and delete."""
    edit(layup)
    tree = widget("rows", QtGui.QTreeWidget)
    assert tree.dragDropMode() == QtGui.QAbstractItemView.InternalMove
    names = lambda: [tree.topLevelItem(row).text(0) for row in range(tree.topLevelItemCount())]
    click("mirror")
    assert names() == ["P1", "P2", "P3", "P4", "P5", "P6"], names()
    click("delete")
    assert names() == ["P1", "P2", "P3"]
    tree.clearSelection()
    tree.topLevelItem(1).setSelected(True)
    click("duplicate")
    assert names() == ["P1", "P2", "P4", "P3"], names()
    choice = widget("angles", QtGui.QComboBox)
    choice.setFocus()
    QTest.keyClicks(choice, "90")
    assert tree.topLevelItem(2).text(3) == "90", tree.topLevelItem(2).text(3)
    click("down")
    assert names() == ["P1", "P2", "P3", "P4"], names()
    click("up")
    drag_row(tree, 0, 3)
    assert names() == ["P2", "P4", "P3", "P1"], names()
    drag_row(tree, 1, 0, above=True)
    assert names() == ["P4", "P2", "P3", "P1"], names()
    moved = tree.topLevelItem(3)
    assert [moved.text(column) for column in range(7)] == ["P1", "AS4-8552S-PW-193", "", "45", "1", "", ""]
    assert moved.checkState(7) == QtCore.Qt.Checked and moved.flags() & DRAGGED
    assert widget("total", QtGui.QLabel).text() == "8 plies, 1.172 mm", widget("total", QtGui.QLabel).text()
    press(BUTTON.Cancel)


def make_stack(doc, base, layup):
    """The face is picked with the mouse, the layup is there already."""
    Gui.Selection.clearSelection()
    run_command("LaminateOffset_PlyStack")
    click_in_view(point=inside_point(base.Shape.Face1))
    press(BUTTON.Ok)
    (stack,) = [obj for obj in doc.Objects if obj.Name.startswith("PlyStack")]
    assert stack.Status == "ok" and stack.PlyCount == 6 and stack.Layup == layup, stack.Message
    assert len(stack.Shape.Faces) == 6 and len(set(stack.ViewObject.DiffuseColor)) == 3
    assert all("Touched" not in obj.State for obj in doc.Objects)
    return stack


def children(doc, stack) -> None:
    """As named plies: one object a ply, below the stack in the tree, in the colours of the angles."""
    edit(stack)
    widget("output", QtGui.QComboBox).setCurrentText("Named plies")
    click("preview")
    press(BUTTON.Ok)
    plies = stack.ViewObject.Proxy.claimChildren()
    assert [ply.Label for ply in plies] == ["P1", "P2", "P3", "P3.2", "P2.2", "P1.2"], [p.Label for p in plies]
    assert len({ply.ViewObject.ShapeColor for ply in plies}) == 3 and not stack.ViewObject.Visibility
    assert all(ply.Shape.isValid() and "Touched" not in ply.State for ply in plies)
    stack.Colours = "by material"
    assert len({ply.ViewObject.ShapeColor for ply in plies}) == 2
    stack.Colours = "by angle"
    look_at_all()
    screenshot("named_plies")


def sample(doc, stack) -> None:
    """A point of the topmost ply is clicked; the plies below it are listed."""
    select(stack, "")
    run_command("LaminateOffset_CoreSample")
    top = stack.ViewObject.Proxy.claimChildren()[-1]
    click_in_view(point=inside_point(top.Shape.Face1))
    tree = widget("plies", QtGui.QTreeWidget)
    assert tree.topLevelItemCount() == 6 and tree.topLevelItem(5).text(0) == "P1", result_text()
    assert tree.topLevelItem(0).text(4) == "0.91", tree.topLevelItem(0).text(4)
    screenshot("core_sample")
    press(BUTTON.Ok)
    (core,) = [obj for obj in doc.Objects if obj.Name.startswith("CoreSample")]
    assert core.PlyCount == 6 and abs(core.Shape.Length - 0.91) < 1e-6


def ply_book(stack) -> None:
    """Through the command and the file dialog."""
    path = os.path.join(OUT, "book.html")

    def save() -> None:
        dialog = QtGui.QApplication.activeModalWidget()
        QTest.keyClicks(dialog.findChild(QtGui.QLineEdit, "fileNameEdit"), path)
        dialog.accept()

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(stack.Document.Name, stack.Name)
    pump(200)
    QtCore.QTimer.singleShot(1500, save)
    run_command("LaminateOffset_ExportPlyBook")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    assert "PlyStack" in text and text.count("<img") >= 6, text[:300]
    Gui.Selection.clearSelection()


def undo_redo_and_reopen(doc) -> None:
    """One step a panel; everything is there after reopening, and follows the layup."""
    doc.undo()
    assert doc.getObject("CoreSample") is None
    doc.redo()
    path = os.path.join(OUT, "stack.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    stack = doc.getObject("PlyStack")
    plies = stack.ViewObject.Proxy.claimChildren()
    assert len(plies) == 6 and doc.CoreSample.PlyCount == 6
    doc.Layup.Symmetric = False
    doc.recompute()
    assert stack.PlyCount == 3 and len(stack.ViewObject.Proxy.claimChildren()) == 3 and doc.CoreSample.PlyCount == 3
    edit(stack)
    type_into("tolerance", "0.01 mm")
    press(BUTTON.Ok)
    assert stack.Tolerance.Value == 0.01 and stack.Status == "ok"
