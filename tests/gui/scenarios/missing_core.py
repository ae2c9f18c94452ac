# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled part cannot be loaded: choosing the workbench says so, and FreeCAD goes on."""

import sys

import FreeCADGui as Gui
from PySide import QtCore, QtGui
from session import QTest, pump, screenshot, start

TOLD = []


def run() -> None:
    """Called by scenario_runner.py."""
    sys.modules["laminate_offset._core"] = None  # what a missing or foreign module amounts to
    QtCore.QTimer.singleShot(2500, read_and_close)
    start()
    pump(1500)
    assert len(TOLD) == 1, "nothing was told"
    assert "compiled part could not be loaded" in TOLD[0] and "Python of FreeCAD" in TOLD[0], TOLD[0]
    Gui.activateWorkbench("PartWorkbench")
    assert Gui.activeWorkbench().name() == "PartWorkbench"


def read_and_close() -> None:
    """What the box says; then OK."""
    box = QtGui.QApplication.activeModalWidget()
    TOLD.append(box.text())
    screenshot("missing_core")
    QTest.mouseClick(box.button(QtGui.QMessageBox.Ok), QtCore.Qt.LeftButton)
