# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that cuts ply stacks by a plane."""

from typing import Any, Optional

import FreeCAD as App

from ...features.stack_section import global_box, set_usual_plane, usual_exaggeration
from ..texts import translate
from . import base
from .base import FeaturePanel
from .core_sample import stacks

#: The planes of the list, by their normals; what is not among them is left as it is.
_NORMALS = (App.Vector(1, 0, 0), App.Vector(0, 1, 0), App.Vector(0, 0, 1))


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(StackSectionPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(StackSectionPanel, feature)


class StackSectionPanel(FeaturePanel):
    """Chooses stack and plane; the exaggeration and the names belong to the view."""

    FORM = "StackSectionPanel"
    LENGTHS = {"position": "Position"}

    def __init__(self, feature: Any):
        self._stacks = stacks(feature.Document)
        self._view = feature.ViewObject
        self._before = (self._view.Exaggeration, self._view.PlyNames)
        super().__init__(feature)
        self.form.stack.addItems([stack.Label for stack in self._stacks])
        if feature.Stack in self._stacks:
            self.form.stack.setCurrentIndex(self._stacks.index(feature.Stack))
        self._show_plane()
        self.form.exaggeration.setValue(self._view.Exaggeration)
        self.form.names.setChecked(self._view.PlyNames)
        self.form.stack.currentIndexChanged.connect(self._stack_chosen)
        self.form.plane.currentIndexChanged.connect(self._plane_chosen)
        self.form.exaggeration.valueChanged.connect(self._exaggerate)
        self.form.names.toggled.connect(lambda on: setattr(self._view, "PlyNames", on))

    def start(self) -> None:
        """A new section is cut at once, as thick as can be seen well."""
        is_new = self._feature.Status == ""
        if self.missing():
            self.tell(self.missing(), refused=True)
        elif self.compute() and is_new:
            self.form.exaggeration.setValue(usual_exaggeration(self._feature))

    def reject(self) -> bool:
        """Takes everything back; undo knows nothing of how things are shown."""
        self._view.Exaggeration, self._view.PlyNames = self._before
        return super().reject()

    def missing(self) -> str:
        """A stack, when there is none."""
        if self._feature.Stack is None:
            return translate("StackSectionPanel", "There is no ply stack in this document; make one first.")
        return ""

    def _show_plane(self) -> None:
        """The plane in the list; one that is askew is the last entry."""
        names = ("x", "y", "z")
        self.form.plane.addItems([translate("StackSectionPanel", "across {axis}").format(axis=name) for name in names])
        index = self._index()
        if index is None:
            normal = self._feature.Normal
            self.form.plane.addItem(f"({normal.x:.4g}, {normal.y:.4g}, {normal.z:.4g})")
        self.form.plane.setCurrentIndex(len(names) if index is None else index)

    def _index(self) -> Optional[int]:
        return next(
            (index for index, normal in enumerate(_NORMALS) if normal.isEqual(self._feature.Normal, 1e-12)), None
        )

    def _stack_chosen(self, index: int) -> None:
        self._feature.Stack = self._stacks[index]
        set_usual_plane(self._feature)
        self._plane_shown()
        self.compute()

    def _plane_chosen(self, index: int) -> None:
        if index < len(_NORMALS) and self._feature.Stack is not None:
            self._feature.Normal = _NORMALS[index]
            self._feature.Position = _NORMALS[index].dot(global_box(self._feature.Stack).Center)
            self._plane_shown()
            self.compute()

    def _plane_shown(self) -> None:
        self.form.position.setProperty("value", self._feature.Position)
        index = self._index()
        if index is not None and index != self.form.plane.currentIndex():
            self.form.plane.blockSignals(True)
            self.form.plane.setCurrentIndex(index)
            self.form.plane.blockSignals(False)

    def _exaggerate(self, factor: float) -> None:
        self._view.Exaggeration = factor
