# SPDX-License-Identifier: LGPL-2.1-or-later
"""Esc during a stack of 200 plies: the work ends soon, the panel stays, and a smaller stack then succeeds."""

import dataclasses
import os
import time

import FreeCADGui as Gui
import Part
from laminate_offset.features.layup import make_layup, set_layup
from laminate_offset.layup import layup_from_notation
from PySide import QtCore, QtGui
from session import (
    QTest,
    look_at_all,
    press,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    select,
    start,
    type_into,
)

BUTTON = QtGui.QDialogButtonBox
DATA = os.path.join(os.path.dirname(os.environ["LAMINATE_OFFSET_PROJECT_DIR"]), "shared", "data")


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start()
    base = doc.addObject("Part::Feature", "Blade")
    base.Shape = Part.read(os.path.join(DATA, "iea15_CFD.igs")).Faces[0]
    layup = make_layup(doc, plies_of(200))
    doc.recompute()
    assert layup.PlyCount == 200
    look_at_all()
    select(base, "Face1")
    run_command("LaminateOffset_PlyStack")
    type_into("tolerance", "0.00001 mm")
    cancelled_by_escape(doc)
    set_layup(layup, plies_of(2))
    type_into("tolerance", "0.01 mm")
    press(BUTTON.Ok)
    stack = doc.getObject("PlyStack")
    assert stack.Status == "ok" and stack.PlyCount == 2 and not Gui.Control.activeDialog(), stack.Message


def plies_of(count: int):
    """Plies of 0.03 mm, so that 200 of them fit below the face's smallest radius."""
    layup = layup_from_notation(f"[0]{count}", "IM7-8552-134")
    return dataclasses.replace(layup, plies=tuple(dataclasses.replace(ply, thickness=0.03) for ply in layup.plies))


def cancelled_by_escape(doc) -> None:
    """The dialog shows how far the work is; Esc ends it."""
    seen = []

    def escape() -> None:
        box = QtGui.QApplication.activeModalWidget()
        if seen or not isinstance(box, QtGui.QProgressDialog) or not box.isVisible():
            return
        screenshot("progress_200")
        seen.append(time.monotonic())
        QTest.keyClick(box, QtCore.Qt.Key_Escape)

    watch = QtCore.QTimer()
    watch.timeout.connect(escape)
    watch.start(50)
    press(BUTTON.Ok)
    watch.stop()
    assert seen, "the stack was made before Esc could be pressed"
    with open("figures.txt", "w", encoding="utf-8") as file:
        file.write(f"ended {time.monotonic() - seen[0]:.1f} s after Esc\n")
    stack = doc.getObject("PlyStack")
    assert Gui.Control.activeDialog() and result_is_red() and "cancelled" in result_text(), result_text()
    assert stack.Status == "cancelled" and stack.Shape.isNull()
