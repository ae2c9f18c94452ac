# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Deviation Map"."""

from typing import Any

import FreeCAD as App

from ...features.deviation_map import make_deviation_map
from ...features.offset_face import OffsetFaceFeature
from .base import Command, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class DeviationMapCommand(Command):
    """Shows in colours how far the selected offsets are from the exact ones."""

    NAME = "LaminateOffset_DeviationMap"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_DeviationMap", "Deviation Map")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_DeviationMap", "Shows in colours how far the selected offset is from the exact one"
    )
    ACCEL = "L, D"

    def fits(self) -> bool:
        """An offset is selected."""
        return bool(selected_of(OffsetFaceFeature))

    def run(self, doc: Any) -> None:
        """Makes a map of every selected offset."""
        import FreeCADGui

        offsets = selected_of(OffsetFaceFeature)
        FreeCADGui.Selection.clearSelection()  # its colour would hide the map's
        for offset in offsets:
            self.create(offset)
        doc.commitTransaction()

    @staticmethod
    def create(offset: Any) -> Any:
        """A computed map of an offset object."""
        return make_deviation_map(offset)
