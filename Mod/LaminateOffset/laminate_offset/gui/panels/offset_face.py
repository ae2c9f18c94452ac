# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits offset faces. Its live preview is computed in another thread."""

from typing import Any, List

import FreeCADGui
from PySide import QtCore

from ... import messages
from ...errors import describe_range
from ...features.base_face import BaseFaceError, linked_faces
from ...features.face_grid import face_grid
from ...features.offset_face import OffsetRequest, describe_results, prepare, set_base
from ...features.offset_limits import limits_of
from ...messages import feasible_range
from ..direction_arrow import DirectionArrow
from ..preview import Preview, drawing
from ..selection import Link
from ..texts import translate
from ..worker import Job, Newest
from . import base
from .base import FacePanel

#: Wait after the last change before a live preview is computed [ms].
PREVIEW_DELAY_MS = 350

_POLL_MS = 30
#: Between two steps of the progress bar [ms].
_STEP_MS = 200


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(OffsetFacePanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(OffsetFacePanel, feature)


class OffsetFacePanel(FacePanel):
    """Edits one offset."""

    FORM = "OffsetFacePanel"
    LENGTHS = {"distance": "Distance", "tolerance": "Tolerance"}
    CHOICES = {"method": "Method"}
    NUMBERS = {"maxDegree": "MaxDegree"}

    def __init__(self, feature: Any):
        view = FreeCADGui.getDocument(feature.Document.Name).ActiveView
        self._arrow = DirectionArrow(view)
        self._preview = Preview(view)
        self._newest = Newest(self._previewed)
        super().__init__(feature)
        self.form.progress.setVisible(False)
        self._delay = QtCore.QTimer(self.form)
        self._delay.setSingleShot(True)
        self._delay.setInterval(PREVIEW_DELAY_MS)
        self._delay.timeout.connect(self._start_preview)
        self._poll = QtCore.QTimer(self.form)
        self._poll.setInterval(_POLL_MS)
        self._poll.timeout.connect(self._watch)
        self._last_step = QtCore.QElapsedTimer()
        self._last_step.start()
        self.form.flip.clicked.connect(self._flip)
        self.form.livePreview.toggled.connect(self._toggle_live)

    def start(self) -> None:
        """The panel is visible: ask for a face when there is none, and show the direction."""
        super().start()
        self._show_direction()
        self._show_range(self._feature.Limits)

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        set_base(self._feature, links)

    def faces_changed(self) -> None:
        """Other faces are picked than before."""
        self._show_range("")
        super().faces_changed()
        self._show_direction()

    def changed(self) -> None:
        """Starts a live preview after a short wait; without one, asks for it."""
        self._stop_preview()
        self._show_direction()
        if self.form.livePreview.isChecked() and self.has_base():
            self._delay.start()
        else:
            super().changed()

    def compute(self, *checked: Any) -> bool:
        """Recomputes the object; what a live preview has computed is not computed again."""
        self._stop_preview()
        return super().compute(*checked)

    def show_result(self) -> None:
        """Shows what the last recompute told."""
        super().show_result()
        self._show_range(self._feature.Limits)

    def closing(self) -> None:
        """Called before the panel closes."""
        super().closing()
        self._stop_preview()
        self._arrow.remove()

    def _flip(self) -> None:
        expression = dict(self._feature.ExpressionEngine).get("Distance")
        if expression:
            self._feature.setExpression("Distance", f"-({expression})")
        self.form.distance.setProperty("value", -self._feature.Distance)

    def _toggle_live(self, _on: bool) -> None:
        self.changed()

    def _show_range(self, text: str) -> None:
        self.form.range.setText(text or translate("OffsetFacePanel", "known after the first result"))

    def _show_direction(self) -> None:
        try:
            faces = [face for _, face in linked_faces(self._feature.Base)]
        except BaseFaceError:
            faces = []
        self._arrow.show(faces, self._feature.Distance.Value)

    def _start_preview(self) -> None:
        """Gives what is asked for now to the worker."""
        try:
            request = OffsetRequest.of(self._feature)
        except BaseFaceError as error:
            self.tell(str(error), refused=True)
            return
        self._newest.start(lambda report: _compute(request, report))
        self._poll.start()
        self.form.progress.setVisible(True)
        self.tell(translate("OffsetFacePanel", "Computing the preview..."))

    def _watch(self) -> None:
        if self._last_step.elapsed() >= _STEP_MS:
            self._last_step.restart()
            self._show_progress(int(1000 * self._newest.fraction))
        self._newest.poll()
        if not self._newest.busy:
            self._poll.stop()
            self.form.progress.setVisible(False)

    def _show_progress(self, value: int) -> None:
        """Qt draws a bar's new value at once, and the whole window with it: here it is drawn with all else that waits."""
        bar = self.form.progress
        if bar.value() != value:
            bar.setUpdatesEnabled(False)
            bar.setValue(value)
            bar.setUpdatesEnabled(True)

    def _stop_preview(self) -> None:
        """Ends what is being computed and takes the preview away: it no longer shows what is asked for."""
        if not hasattr(self, "_delay"):
            return  # still being filled
        self._delay.stop()
        self._newest.cancel()
        self._preview.remove()

    def _previewed(self, job: Job) -> None:
        """The worker has an outcome of what is asked for."""
        try:
            request, results, pictures, limits = job.result()
        except Exception as error:  # a refusal, or a defect that the user must see as well
            self.tell(messages.refusal(error, getattr(error, "face", "")), refused=True)
            self._show_range(feasible_range(getattr(error, "feasible_range", None)))
            region = getattr(error, "fold_region", None)
            self._preview.mark(getattr(error, "where", None), getattr(error, "status", ""), region)
            return
        prepare(self._feature, request, results)
        elapsed = sum(result.report.elapsed_ms.total for result in results)
        self.tell(f"{describe_results(results)}; {elapsed:.0f} ms")
        self._show_range(describe_range(tuple(None if limit is None else limit.distance for limit in limits)))
        self._preview.show(pictures, [limit for limit in limits if limit is not None])


def _compute(request: OffsetRequest, report: Any) -> Any:
    """In the worker: the offsets, what is drawn of them, and the tightest limits of both sides."""
    results = request.compute(report)
    pictures = [drawing(face_grid(face), request.distance) for _, face in request.faces]
    return request, results, pictures, limits_of(request.faces, report)[1]
