# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Offset Face"."""

from typing import Any, List

import FreeCAD as App

from ...features.offset_face import add_offset_face, set_base
from .. import preferences
from ..selection import Link, selected_faces
from .base import FaceCommand

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class OffsetFaceCommand(FaceCommand):
    """Makes an offset of the selected faces, of one or several objects, and opens its task panel."""

    NAME = "LaminateOffset_OffsetFace"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_OffsetFace", "Offset Face")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_OffsetFace", "Offsets the selected faces by a constant distance, within a tolerance"
    )
    ACCEL = "L, O"

    def run(self, doc: Any) -> None:
        """Opens the panel on a new offset; OK keeps it, Cancel takes it back."""
        from ..panels.offset_face import open_new

        open_new(self.create(selected_faces(), doc))

    @staticmethod
    def create(links: List[Link], doc: Any) -> Any:
        """An offset of all linked faces, not yet computed; without links it has no base."""
        feature = add_offset_face(doc)
        feature.Tolerance = preferences.tolerance()
        feature.Method = preferences.method()
        feature.MaxDegree = preferences.max_degree()
        if links:
            set_base(feature, links)
        return feature
