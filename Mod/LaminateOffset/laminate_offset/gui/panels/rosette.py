# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits rosettes."""

from typing import Any

import FreeCAD as App
import FreeCADGui
from PySide import QtCore

from ...features.base_face import describe
from ...features.rosette import set_support
from ..commands.rosette import carries
from ..selection import ElementPicker
from ..texts import translate
from . import base
from .base import FeaturePanel

_DIRECTIONS = (App.Vector(1, 0, 0), App.Vector(0, 1, 0), App.Vector(0, 0, 1))


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(RosettePanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(RosettePanel, feature)


class RosettePanel(FeaturePanel):
    """Attaches one rosette and turns it. It is drawn at once."""

    FORM = "RosettePanel"
    LENGTHS = {"turn": "Turn"}

    def __init__(self, feature: Any):
        self._picker = ElementPicker([feature], carries, self._picked)
        super().__init__(feature)
        names = [translate("RosettePanel", "along {axis}").format(axis=axis) for axis in "xyz"]
        self.form.direction.addItems(names)
        index = next((i for i, axis in enumerate(_DIRECTIONS) if axis.isEqual(feature.Direction, 1e-12)), None)
        if index is None:
            way = feature.Direction
            self.form.direction.addItem(f"({way.x:.4g}, {way.y:.4g}, {way.z:.4g})")
        self.form.direction.setCurrentIndex(len(names) if index is None else index)
        self.form.direction.currentIndexChanged.connect(self._direction_chosen)
        self.form.pick.toggled.connect(self._toggle_picking)
        self._show_support()

    def start(self) -> None:
        """Asks for a place where there is none; shows the rosette where there is."""
        FreeCADGui.Selection.clearSelection()
        if self._feature.Support:
            self.compute()
        else:
            self.form.pick.setChecked(True)

    def changed(self) -> None:
        """It takes no time: the rosette follows every change."""
        if self._feature.Support or not self._feature.Attached:
            self.compute()

    def closing(self) -> None:
        """Called before the panel closes."""
        self._picker.stop()

    def _show_support(self) -> None:
        support = self._feature.Support
        text = describe(support[0], support[1][0]) if support else translate("RosettePanel", "none")
        self.form.support.setText(text.rstrip(": "))

    def _toggle_picking(self, picking: bool) -> None:
        if picking:
            self._picker.start()
            self.tell(translate("RosettePanel", "Click a face, an edge or a point in the 3-D view."))
        else:
            self._picker.stop()

    def _picked(self, obj: Any, sub: str, point: Any) -> None:
        set_support(self._feature, obj, sub)
        self._feature.Point = App.Vector(*point)
        self._show_support()
        self.compute()
        # The colour of the selection would hide the axes; not from within the selection's own call.
        QtCore.QTimer.singleShot(0, FreeCADGui.Selection.clearSelection)

    def _direction_chosen(self, index: int) -> None:
        if index < len(_DIRECTIONS):
            self._feature.Direction = _DIRECTIONS[index]
            self.changed()
