# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drag and drop by mouse: Qt runs a loop of its own until the button is released, so the hand moves on by a timer."""

from typing import Any

from PySide import QtCore, QtGui
from session import pump

_STEPS = 8
_PAUSE_MS = 60


def drag_row(tree: Any, source: int, target: int, above: bool = False) -> None:
    """Drags a row of a tree to below another one, or above it."""
    start = tree.visualItemRect(tree.topLevelItem(source)).center()
    box = tree.visualItemRect(tree.topLevelItem(target))
    end = QtCore.QPoint(start.x(), box.top() + 1 if above else box.bottom() - 1)
    tree.clearSelection()
    _send(tree.viewport(), QtCore.QEvent.MouseButtonPress, start)
    pump(100)
    hand = _Hand(tree.viewport(), start, end)
    # The first move past the least distance of a drag enters Qt's loop, and comes back once the row is dropped.
    distance = 2 * QtGui.QApplication.startDragDistance()
    for step in (distance, 2 * distance):
        if not hand.released:
            _send(
                tree.viewport(),
                QtCore.QEvent.MouseMove,
                start + QtCore.QPoint(0, step if end.y() > start.y() else -step),
            )
    pump(_PAUSE_MS * (_STEPS + 6))
    assert hand.released, "the mouse button was never released"


class _Hand:
    """Moves the real pointer in steps from one place of a widget to another, then lets the button go."""

    def __init__(self, widget: Any, start: Any, end: Any):
        self.released = False
        self._widget, self._start, self._end = widget, start, end
        self._step = 0
        self._timer = QtCore.QTimer()
        self._timer.setInterval(_PAUSE_MS)
        self._timer.timeout.connect(self._move)
        self._timer.start()

    def _move(self) -> None:
        self._step += 1
        share = min(self._step / _STEPS, 1.0)
        place = self._start + (self._end - self._start) * share
        if self._step <= _STEPS + 2:  # at the end it rests, until the window has answered
            QtGui.QCursor.setPos(self._widget.mapToGlobal(place + QtCore.QPoint(self._step % 2, 0)))
            return
        self._timer.stop()
        self.released = True
        _send(self._widget, QtCore.QEvent.MouseButtonRelease, self._end)


def _send(widget: Any, kind: Any, place: Any) -> None:
    button = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else QtCore.Qt.LeftButton
    buttons = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease else QtCore.Qt.LeftButton
    event = QtGui.QMouseEvent(kind, place, widget.mapToGlobal(place), button, buttons, QtCore.Qt.NoModifier)
    QtGui.QApplication.sendEvent(widget, event)
