# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Extend Face"."""

from typing import Any, List

import FreeCAD as App

from ...features.base_face import rooted_links
from ...features.extend_face import add_extend_face
from ..selection import Link, selected_faces
from .base import FaceCommand

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class ExtendFaceCommand(FaceCommand):
    """Makes an extension of the selected faces and opens its task panel."""

    NAME = "LaminateOffset_ExtendFace"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ExtendFace", "Extend Face")
    TIP = QT_TRANSLATE_NOOP("LaminateOffset_ExtendFace", "Makes the selected faces longer past their sides by a length")
    ACCEL = "L, E"

    def run(self, doc: Any) -> None:
        """Opens the panel on a new extension; OK keeps it, Cancel takes it back."""
        from ..panels.extend_face import open_new

        open_new(self.create(selected_faces(), doc))

    @staticmethod
    def create(links: List[Link], doc: Any) -> Any:
        """An extension of all linked faces, not yet computed; without links it has no base."""
        feature = add_extend_face(doc)
        feature.Base = rooted_links(links)
        return feature
