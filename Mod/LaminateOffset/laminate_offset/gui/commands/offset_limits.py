# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Offset Limits"."""

from typing import Any, List

import FreeCAD as App

from ...features.base_face import rooted_links
from ...features.offset_limits import add_offset_limits
from ..selection import Link, selected_faces
from .base import FaceCommand

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class OffsetLimitsCommand(FaceCommand):
    """Shows how far the selected faces can be offset, and marks the places on the model."""

    NAME = "LaminateOffset_OffsetLimits"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_OffsetLimits", "Offset Limits")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_OffsetLimits", "Shows how far faces can be offset, and where an offset would fold first"
    )
    ACCEL = "L, F"

    def run(self, doc: Any) -> None:
        """Opens the panel on new limits; OK keeps the marks, Cancel takes them back."""
        from ..panels.offset_limits import open_new

        open_new(self.create(selected_faces(), doc))

    @staticmethod
    def create(links: List[Link], doc: Any) -> Any:
        """Limits of all linked faces, not yet computed; without links they have no base."""
        feature = add_offset_limits(doc)
        feature.Base = rooted_links(links)
        return feature
