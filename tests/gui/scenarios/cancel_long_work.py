# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that takes long shows its progress; Esc or Cancel ends it and the panel stays."""

import time

import FreeCADGui as Gui
import laminate_offset
from PySide import QtCore, QtGui
from session import QTest, offsets, press, result_is_red, result_text, run_command, screenshot, select, start

BUTTON = QtGui.QDialogButtonBox
SECONDS = 30.0


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start()
    doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    select(doc.getObject("Ball"), "Face1")
    run_command()
    engine, seen = laminate_offset.offset_face, []
    laminate_offset.offset_face = slowed(engine, seen)
    for gesture in (press_escape, press_cancel):
        cancelled_by(gesture, doc, seen)
    laminate_offset.offset_face = engine
    press(BUTTON.Ok)
    (offset,) = offsets(doc)
    assert offset.Status == "ok" and not Gui.Control.activeDialog()


def cancelled_by(gesture, doc, seen) -> None:
    """The gesture ends the work soon; the panel stays and says so."""
    seen.clear()
    QtCore.QTimer.singleShot(2000, gesture)
    began = time.monotonic()
    press(BUTTON.Ok)
    assert time.monotonic() - began < SECONDS / 2, f"{gesture.__name__} did not end the work"
    assert Gui.Control.activeDialog() and result_is_red() and "cancelled" in result_text(), result_text()
    (offset,) = offsets(doc)
    assert offset.Status == "cancelled" and offset.Shape.isNull()
    assert 0 < max(seen) < 0.5


def slowed(engine, seen):
    """The engine's function, preceded by work that reports its progress and heeds a cancellation."""

    def offset_face(face, distance, progress=None, **options):
        assert progress is not None, "the GUI must watch the work"
        began = time.monotonic()
        while time.monotonic() - began < SECONDS:
            time.sleep(0.01)
            seen.append((time.monotonic() - began) / SECONDS)
            if not progress(seen[-1]):
                raise laminate_offset.OffsetError("cancelled", "surface", "The computation was cancelled.")
        return engine(face, distance, progress=progress, **options)

    return offset_face


def progress_dialog():
    """The dialog, which must be on top and tell how far the work is."""
    box = QtGui.QApplication.activeModalWidget()
    assert isinstance(box, QtGui.QProgressDialog), box
    assert 0 < box.value() < box.maximum() and "OffsetFace" in box.labelText()
    return box


def press_escape() -> None:
    """What a user does who lost patience."""
    box = progress_dialog()
    screenshot("progress")
    QTest.keyClick(box, QtCore.Qt.Key_Escape)


def press_cancel() -> None:
    """The same with the mouse."""
    (button,) = progress_dialog().findChildren(QtGui.QPushButton)
    QTest.mouseClick(button, QtCore.Qt.LeftButton)
