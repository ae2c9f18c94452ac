# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn beside the shapes: curvature map, fold region of a refusal, exploded view and section of a stack."""

import math
import os

import FreeCAD as App
import FreeCADGui as Gui
from models import hide_docks, only, wavy_document
from PySide import QtCore, QtGui
from session import (
    OUT,
    QTest,
    click,
    edit,
    look_at_all,
    press,
    pump,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    select,
    type_into,
    view_image,
    widget,
    words_in,
)

BUTTON = QtGui.QDialogButtonBox
TABLE = os.path.join(
    os.environ["LAMINATE_OFFSET_BUILD_DIR"], "Mod", "LaminateOffset", "resources", "examples", "layup_plain.csv"
)


def run() -> None:
    """Called by scenario_runner.py."""
    doc, base = wavy_document(1280, 720)
    hide_docks()
    look_at_all()
    curvature(doc, base)
    fold(doc, base)
    fold_in_preview(base)
    stack = stacked(doc, base)
    exploded(stack)
    section(doc, stack)
    reopened(doc)


def curvature(doc, base) -> None:
    """The legend has the distance's share of the limit, and the limits of both sides; what folds has a colour of its own."""
    select(base, "Face1")
    run_command("LaminateOffset_CurvatureMap")
    chart = only(doc, "CurvatureMap")
    assert "1 mm" in words_in(chart) and "100 %" in words_in(chart), words_in(chart)
    base.ViewObject.Visibility = False
    type_into("distance", "60 mm")
    press_preview()
    assert chart.Status == "ok" and chart.LargestUse > 1.9 and chart.FoldedArea.Value > 100, chart.Message
    assert "folds on" in result_text() and "60 mm" in words_in(chart) and "folds" in words_in(chart)
    assert dark_red(view_image()) > 500, "what folds is not seen"
    screenshot("curvature")
    widget("shows", QtGui.QComboBox).setCurrentText("limit outwards")
    press_preview()
    assert f"{chart.Outwards.Value:.4g} mm" in words_in(chart) and "any" in words_in(chart), words_in(chart)
    screenshot("limit_outwards")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog()
    base.ViewObject.Visibility = True
    chart.ViewObject.Visibility = False


def press_preview() -> None:
    """The panel's button."""
    click("preview")


def dark_red(image) -> int:
    """Pixels of the colour of what folds."""
    return count(image, lambda colour: colour.red() > 2 * colour.green() + 40 and 20 < colour.red() < 130)


def bright_red(image) -> int:
    """Pixels of the colour of a fold region."""
    return count(image, lambda colour: colour.red() > 170 and colour.green() < 140 and colour.blue() < 130)


def count(image, wanted) -> int:
    """How many pixels are wanted, of every second in each direction, four times."""
    places = ((x, y) for x in range(0, image.width(), 2) for y in range(0, image.height(), 2))
    return 4 * sum(1 for x, y in places if wanted(QtGui.QColor(image.pixel(x, y))))


def fold(doc, base) -> None:
    """A refused offset shows the region that folds, not only a point; a good one does not."""
    select(base, "Face1")
    run_command()
    before = bright_red(view_image())
    type_into("distance", "60 mm")
    press(BUTTON.Ok)
    offset = only(doc, "OffsetFace")
    assert offset.Status == "curvature-limit" and result_is_red() and len(offset.FoldPoints) > 100
    assert bright_red(view_image()) > before + 1000, (before, bright_red(view_image()))
    screenshot("fold")
    type_into("distance", "2 mm")
    press(BUTTON.Ok)
    assert offset.Status == "ok" and not offset.FoldPoints and not Gui.Control.activeDialog()
    Gui.Selection.clearSelection()
    pump(200)
    assert bright_red(view_image()) < before + 200
    offset.ViewObject.Visibility = False


def fold_in_preview(base) -> None:
    """The live preview shows the region as well."""
    select(base, "Face1")
    run_command()
    before = bright_red(view_image())
    click("livePreview")
    type_into("distance", "-60 mm")
    pump(2500)
    assert result_is_red() and bright_red(view_image()) > before + 1000, result_text()
    screenshot("fold_preview")
    press(BUTTON.Cancel)
    assert bright_red(view_image()) < before + 200


def stacked(doc, base):
    """A stack of six plies."""
    from laminate_offset.features.layup import import_layup
    from laminate_offset.features.ply_stack import OUTPUTS, make_ply_stack

    stack = make_ply_stack(base, "Face1", import_layup(doc, TABLE), output=OUTPUTS[1])
    assert stack.Status == "ok", stack.Message
    base.ViewObject.Visibility = False
    return stack


def exploded(stack) -> None:
    """The command draws the plies apart and together again; shape and document stay as they are."""
    shape = stack.Shape.exportBrepToString()
    plies = stack.ViewObject.Proxy.claimChildren()
    select(plies[2], "")
    run_command("LaminateOffset_ExplodedView")
    view = stack.ViewObject
    assert view.DisplayMode == "Exploded" and view.Visibility and not any(ply.ViewObject.Visibility for ply in plies)
    assert view.ExplodedFactor > 30 and abs(view.ExplodedDirection.z) > 0.9
    look_at_all()
    assert [word.split()[0] for word in words_in(stack)] == [ply.Label for ply in plies], words_in(stack)
    height = drawn_box(stack)[2]
    assert height > 0.8 * 0.848 * view.ExplodedFactor, height
    screenshot("exploded")
    view.ExplodedAlong = "normal"
    view.ExplodedFactor = 10
    pump(200)
    assert drawn_box(stack)[2] < height
    assert stack.Shape.exportBrepToString() == shape and "Touched" not in stack.State
    select(stack, "")
    run_command("LaminateOffset_ExplodedView")
    assert view.DisplayMode != "Exploded" and not view.Visibility and all(ply.ViewObject.Visibility for ply in plies)
    view.DisplayMode = "Exploded"
    view.Visibility = True


def drawn_box(obj) -> tuple:
    """The size of what is drawn of an object [mm]."""
    from pivy import coin

    action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    action.apply(obj.ViewObject.RootNode)
    return tuple(action.getBoundingBox().getSize())


def section(doc, stack) -> None:
    """A plane, its position by mouse and keys, and the exaggeration, which leaves the shape alone."""
    select(stack, "")
    run_command("LaminateOffset_StackSection")
    cut = only(doc, "StackSection")
    assert cut.Status == "ok" and cut.PlyCount == 6 and cut.Stack == stack, result_text()
    stack.ViewObject.Visibility = False
    exaggeration = cut.ViewObject.Exaggeration
    assert exaggeration == widget("exaggeration").value() >= 2
    type_into("position", "20 mm")
    choice = widget("plane", QtGui.QComboBox)
    choice.setFocus()
    QTest.keyClick(choice, QtCore.Qt.Key_Home)
    QTest.keyClick(choice, QtCore.Qt.Key_Down)
    pump(300)
    assert choice.currentIndex() == 1 and cut.Normal == App.Vector(0, 1, 0), (choice.currentIndex(), cut.Normal)
    assert math.isclose(cut.Position.Value, stack.Shape.BoundBox.Center.y, rel_tol=1e-2)
    type_into("position", "25 mm")
    press_preview()
    assert abs(cut.Shape.BoundBox.YMin - 25) < 1e-9 > abs(cut.Shape.BoundBox.YMax - 25), result_text()
    for ply in stack.ViewObject.Proxy.claimChildren():
        ply.ViewObject.Visibility = False
    thickness = drawn_box(cut)[2]
    type_into("exaggeration", "20")
    pump(300)
    assert cut.ViewObject.Exaggeration == 20 and drawn_box(cut)[2] > thickness + 5
    assert cut.Shape.BoundBox.ZLength < 12 and len(cut.Shape.Faces) == 6
    assert sorted(word.split()[0] for word in words_in(cut)) == [f"P{number}" for number in range(1, 7)]
    Gui.ActiveDocument.ActiveView.viewFront()
    Gui.SendMsgToActiveView("ViewFit")
    screenshot("section")
    click("names")
    assert not words_in(cut)
    click("names")
    type_into("position", "500 mm")
    press(BUTTON.Ok)
    assert Gui.Control.activeDialog() and result_is_red() and "does not cut" in result_text()
    type_into("position", "25 mm")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and cut.Status == "ok"
    edit(cut)
    type_into("exaggeration", "7")
    assert cut.ViewObject.Exaggeration == 7
    press(BUTTON.Cancel)
    assert cut.ViewObject.Exaggeration == 20 and cut.Position.Value == 25


def reopened(doc) -> None:
    """All of it is there after reopening: how things are shown belongs to the view."""
    path = os.path.join(OUT, "seeing.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    doc = App.openDocument(path)
    stack, cut, chart = doc.PlyStack, doc.StackSection, doc.CurvatureMap
    assert stack.ViewObject.DisplayMode == "Exploded" and stack.ViewObject.ExplodedFactor == 10
    assert cut.ViewObject.Exaggeration == 20 and len(words_in(cut)) == 6, words_in(cut)
    assert not stack.ViewObject.Visibility
    stack.ViewObject.Visibility = True
    assert len(words_in(stack)) == 6, words_in(stack)
    look_at_all()
    chart.ViewObject.Visibility = True
    assert "any" in words_in(chart), words_in(chart)
    screenshot("reopened")
