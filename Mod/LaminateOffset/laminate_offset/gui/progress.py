# SPDX-License-Identifier: LGPL-2.1-or-later
"""A progress dialog with Cancel for work that lasts longer than a moment. Esc cancels too."""

import contextlib
from typing import Iterator

import FreeCADGui
from PySide import QtCore, QtGui

from ..features.progress import Report

#: Shorter work shows no dialog [ms].
PATIENCE_MS = 700

_STEPS = 1000


@contextlib.contextmanager
def dialog(title: str) -> Iterator[Report]:
    """Shows progress while the context lasts; the yielded report returns False once the user cancelled."""
    box = QtGui.QProgressDialog(FreeCADGui.getMainWindow())
    box.setObjectName("LaminateOffsetProgress")
    box.setWindowTitle("Laminate Offset")
    box.setLabelText(f"Computing {title}...")
    box.setRange(0, _STEPS)
    box.setWindowModality(QtCore.Qt.ApplicationModal)
    box.setMinimumDuration(PATIENCE_MS)
    box.setAutoReset(False)
    box.setAutoClose(False)
    box.setValue(0)

    def report(fraction: float) -> bool:
        # A modal dialog handles its pending events here, which is how Cancel and Esc get through.
        box.setValue(min(int(fraction * _STEPS), _STEPS))
        return not box.wasCanceled()

    try:
        yield report
    finally:
        box.close()
        box.deleteLater()
