# SPDX-License-Identifier: LGPL-2.1-or-later
"""Started by FreeCAD itself: runs the scenario once the GUI is up and ends the process with a verdict.

FreeCAD runs a failing script a second time and then stays open, so nothing here may raise at import.
"""

import faulthandler
import importlib
import os
import sys
import traceback

import FreeCAD as App
from PySide import QtCore

OUT = os.environ["LAMINATE_OFFSET_GUI_OUT"]
_faults = open(os.path.join(OUT, "faults.txt"), "w", encoding="utf-8")
faulthandler.enable(_faults)
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))


def _run() -> None:
    verdict = "passed"
    try:
        scenario = importlib.import_module(f"scenarios.{os.environ['LAMINATE_OFFSET_GUI_SCENARIO']}")
        scenario.run()
    except BaseException:
        verdict = traceback.format_exc()
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    with open(os.path.join(OUT, "verdict.txt"), "w", encoding="utf-8") as file:
        file.write(verdict)
    os._exit(0 if verdict == "passed" else 1)


# The event loop must have settled before windows are used.
QtCore.QTimer.singleShot(1500, _run)
