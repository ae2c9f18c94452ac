# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that takes core samples of ply stacks."""

import json
from typing import Any, List

import FreeCAD as App
import FreeCADGui
from PySide import QtCore, QtGui

from ...features.ply_stack import PlyFeature, PlyStackFeature
from ..selection import PointPicker
from ..texts import translate
from . import base
from .base import FeaturePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(CoreSamplePanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(CoreSamplePanel, feature)


def stacks(doc: Any) -> List[Any]:
    """The document's ply stacks."""
    return [obj for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), PlyStackFeature)]


class CoreSamplePanel(FeaturePanel):
    """Shows the plies at a point; another click takes another sample."""

    FORM = "CoreSamplePanel"
    WIDTH = 380

    def __init__(self, feature: Any):
        self._picker = PointPicker(self._picked)
        self._stacks = stacks(feature.Document)
        self._has_point = feature.Status != ""
        super().__init__(feature)
        self.form.stack.addItems([stack.Label for stack in self._stacks])
        if feature.Stack is None and self._stacks:
            feature.Stack = self._stacks[0]
        if feature.Stack in self._stacks:
            self.form.stack.setCurrentIndex(self._stacks.index(feature.Stack))
        self.form.stack.currentIndexChanged.connect(self._stack_chosen)
        self.form.pick.toggled.connect(self._toggle_picking)

    def start(self) -> None:
        """Ask for a point, unless there is one."""
        FreeCADGui.Selection.clearSelection()
        if self._has_point:
            self.compute()
        else:
            self.form.pick.setChecked(True)

    def missing(self) -> str:
        """A stack or a point, when there is none."""
        if self._feature.Stack is None:
            return translate("CoreSamplePanel", "There is no ply stack in this document; make one first.")
        if not self._has_point:
            return translate("CoreSamplePanel", "Click a point of the face or the stack in the 3-D view.")
        return ""

    def show_result(self) -> None:
        """Lists the plies from the outermost down to the tool, as they lie."""
        super().show_result()
        self.form.plies.clear()
        point = self._feature.Point
        self.form.point.setText(f"{point.x:.4g}, {point.y:.4g}, {point.z:.4g} mm")
        plies = json.loads(self._feature.ReportJson) if self._feature.Status == "ok" else []
        for ply in reversed(plies):
            words = [ply["name"], ply["material"], f"{ply['angle']:g}\N{DEGREE SIGN}"]
            words += [f"{ply['bottom']:.4g}", f"{ply['top']:.4g}"]
            self.form.plies.addTopLevelItem(QtGui.QTreeWidgetItem(words))
        for column in range(5):
            self.form.plies.resizeColumnToContents(column)

    def closing(self) -> None:
        """Called before the panel closes."""
        self._picker.stop()

    def _toggle_picking(self, picking: bool) -> None:
        if picking:
            self._picker.start()
            self.tell(self.missing() or translate("CoreSamplePanel", "Click another point for another sample."))
        else:
            self._picker.stop()

    def _picked(self, obj: Any, point: Any) -> None:
        if isinstance(getattr(obj, "Proxy", None), PlyFeature):
            obj = obj.Stack
        if obj in self._stacks and obj != self._feature.Stack:
            self.form.stack.setCurrentIndex(self._stacks.index(obj))
        self._feature.Point = App.Vector(*point)
        self._has_point = True
        self.compute()
        # The colour of the selection would hide that of the ply; not from within the selection's own call.
        QtCore.QTimer.singleShot(0, FreeCADGui.Selection.clearSelection)

    def _stack_chosen(self, index: int) -> None:
        if 0 <= index < len(self._stacks) and self._feature.Stack != self._stacks[index]:
            self._feature.Stack = self._stacks[index]
            if self._has_point:
                self.compute()
