# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in another thread, under a progress dialog with Cancel. Esc cancels too. The GUI stays alive meanwhile."""

from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from ..features.progress import Work
from .texts import translate
from .worker import Job

#: Shorter work shows no dialog [ms].
PATIENCE_MS = 700

_STEPS = 1000
_PAUSE_MS = 15


def run(title: str, work: Work) -> Any:
    """Does the work, and returns its result or raises what it raised. The user sees how far it is and can cancel it.

    Until the dialog stands, keys and clicks wait: nothing may change what is being computed.
    """
    job = Job(work)
    box = None
    clock = QtCore.QElapsedTimer()
    clock.start()
    try:
        while not job.wait(_PAUSE_MS / 1000.0):
            if box is None and clock.elapsed() > PATIENCE_MS:
                box = _dialog(title)
            if box is not None:
                box.setValue(min(int(job.fraction * _STEPS), _STEPS))
                if box.wasCanceled():
                    job.cancel()
            flags = QtCore.QEventLoop.ExcludeUserInputEvents if box is None else QtCore.QEventLoop.AllEvents
            QtGui.QApplication.processEvents(flags)
    finally:
        if box is not None:
            box.close()
            box.deleteLater()
    return job.result()


def _dialog(title: str) -> Any:
    box = QtGui.QProgressDialog(FreeCADGui.getMainWindow())
    box.setObjectName("LaminateOffsetProgress")
    box.setWindowTitle("Laminate Offset")
    box.setLabelText(translate("LaminateOffset", "Computing {title}...").format(title=title))
    box.setRange(0, _STEPS)
    box.setWindowModality(QtCore.Qt.ApplicationModal)
    box.setMinimumDuration(0)
    box.setAutoReset(False)
    box.setAutoClose(False)
    box.setValue(0)
    box.show()
    return box
