# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits offset faces."""

from typing import Any, List

import FreeCADGui
from PySide import QtCore, QtGui

from ...features.base_face import BaseFaceError, describe, linked_faces, rooted
from ...features.offset_face import set_base
from ..direction_arrow import DirectionArrow
from ..resources import form
from ..selection import FacePicker

#: Wait after the last change before a live preview is computed [ms].
PREVIEW_DELAY_MS = 350


def open_new(doc: Any, features: List[Any]) -> None:
    """Shows the panel on objects that were just made in an open transaction."""
    panel = OffsetFacePanel(doc, features)
    FreeCADGui.Control.showDialog(panel)
    panel.start()


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    doc = feature.Document
    doc.openTransaction(f"Edit {feature.Label}")
    panel = OffsetFacePanel(doc, [feature])
    FreeCADGui.Control.showDialog(panel)
    panel.start()


class OffsetFacePanel:
    """Edits one or more offset objects at once; FreeCAD calls the methods with its names (accept, reject...)."""

    def __init__(self, doc: Any, features: List[Any]):
        self._doc = doc
        self._features = features
        self._picker = FacePicker(features, self._picked)
        self._arrow = DirectionArrow(FreeCADGui.getDocument(doc.Name).ActiveView)
        self.form = FreeCADGui.PySideUic.loadUi(form("OffsetFacePanel"))
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PREVIEW_DELAY_MS)
        self._fill()
        self._connect()

    def start(self) -> None:
        """The panel is visible: ask for a face when there is none, and show the direction."""
        # The colour of the selection would hide the base and the preview.
        FreeCADGui.Selection.clearSelection()
        self._show_direction()
        if self._has_base():
            self._show_result()
        else:
            self.form.pick.setChecked(True)

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        return int(QtGui.QDialogButtonBox.Ok) | int(QtGui.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        """Keeps the offset, unless it was refused: then the panel stays and says why."""
        if not self._compute():
            return False
        self._close()
        self._doc.recompute()
        self._doc.commitTransaction()
        self._end_editing()
        return True

    def reject(self) -> bool:
        """Takes back everything since the panel was opened."""
        self._close()
        self._doc.abortTransaction()
        self._end_editing()
        self._doc.recompute()
        return True

    def _fill(self) -> None:
        first = self._features[0]
        for box, name in ((self.form.distance, "Distance"), (self.form.tolerance, "Tolerance")):
            box.setProperty("value", getattr(first, name))
            FreeCADGui.ExpressionBinding(box).bind(first, name)
        # With several objects it would not be clear whose face is replaced.
        self.form.pick.setEnabled(len(self._features) == 1)
        self._show_faces()

    def _connect(self) -> None:
        self.form.distance.valueChanged.connect(self._distance_changed)
        self.form.tolerance.valueChanged.connect(self._tolerance_changed)
        self.form.flip.clicked.connect(self._flip)
        self.form.preview.clicked.connect(self._compute)
        self.form.pick.toggled.connect(self._toggle_picking)
        self.form.livePreview.toggled.connect(self._changed)
        self._timer.timeout.connect(self._compute)

    def _distance_changed(self, *_value: Any) -> None:
        self._assign("Distance", self.form.distance.property("rawValue"))
        self._show_direction()
        self._changed()

    def _tolerance_changed(self, *_value: Any) -> None:
        self._assign("Tolerance", self.form.tolerance.property("rawValue"))
        self._changed()

    def _assign(self, name: str, value: float) -> None:
        """Gives every object the value [mm], or the expression that the first one got from the f(x) button."""
        expression = dict(self._features[0].ExpressionEngine).get(name)
        for feature in self._features:
            feature.setExpression(name, expression)
            setattr(feature, name, value)

    def _flip(self) -> None:
        first = self._features[0]
        expression = dict(first.ExpressionEngine).get("Distance")
        if expression:
            first.setExpression("Distance", f"-({expression})")
        self.form.distance.setProperty("value", -first.Distance)

    def _changed(self, *_state: Any) -> None:
        if self.form.livePreview.isChecked():
            self._timer.start()
        else:
            self._timer.stop()
            self._tell("Press Preview to see the offset, or OK to make it.")

    def _toggle_picking(self, picking: bool) -> None:
        if picking:
            self._picker.start()
            self._tell("Click a face in the 3-D view.")
        else:
            self._picker.stop()

    def _picked(self, base: Any, sub: str) -> None:
        """The first picked face replaces the link; a further face of the same object joins it."""
        feature = self._features[0]
        root, path = rooted(base, sub)
        old = list(feature.Base[1]) if self._adds_to(feature, root) else []
        set_base(feature, root, old + [path] if path not in old else old)
        self._show_faces()
        self._show_direction()
        self._changed()

    def _adds_to(self, feature: Any, root: Any) -> bool:
        keys = QtGui.QApplication.keyboardModifiers()
        return bool(keys & QtCore.Qt.ControlModifier) and feature.Base is not None and feature.Base[0] == root

    def _has_base(self) -> bool:
        return all(feature.Base is not None and feature.Base[1] for feature in self._features)

    def _show_faces(self) -> None:
        texts = []
        for feature in self._features:
            if feature.Base is not None and feature.Base[0] is not None:
                base, subs = feature.Base
                texts.append(", ".join(describe(base, sub) for sub in subs))
        self.form.faces.setText("; ".join(texts))

    def _show_direction(self) -> None:
        faces: List[Any] = []
        for feature in self._features:
            try:
                faces.extend(face for _, face in linked_faces(feature))
            except BaseFaceError:
                continue
        self._arrow.show(faces, self._features[0].Distance.Value)

    def _compute(self, *_checked: Any) -> bool:
        """Recomputes every object and shows the outcome. Returns whether all are valid."""
        self._timer.stop()
        if not self._has_base():
            self._tell("Pick a face first: press Pick and click a face in the 3-D view.", refused=True)
            return False
        for feature in self._features:
            feature.touch()
        self._doc.recompute(self._features)
        self._show_result()
        return all(feature.Status == "ok" for feature in self._features)

    def _show_result(self) -> None:
        refused = [feature.Message for feature in self._features if feature.Status != "ok"]
        messages = refused or [feature.Message for feature in self._features]
        self._tell("\n".join(messages), refused=bool(refused))

    def _tell(self, text: str, refused: bool = False) -> None:
        self.form.result.setStyleSheet("color: #cc0000;" if refused else "")
        self.form.result.setText(text)

    def _close(self) -> None:
        self._timer.stop()
        self._picker.stop()
        self._arrow.remove()
        FreeCADGui.Control.closeDialog()

    def _end_editing(self) -> None:
        """Only after the transaction has ended: FreeCAD commits an open one here."""
        gui_document = FreeCADGui.getDocument(self._doc.Name)
        if gui_document.getInEdit() is not None:
            gui_document.resetEdit()
