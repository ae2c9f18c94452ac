# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Curvature Map"."""

from typing import Any, List

import FreeCAD as App

from ...features.base_face import rooted_links
from ...features.curvature_map import add_curvature_map
from ..selection import Link, selected_faces
from .base import FaceCommand

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class CurvatureMapCommand(FaceCommand):
    """Shows in colours how near a distance is to the curvature limit of the selected faces."""

    NAME = "LaminateOffset_CurvatureMap"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_CurvatureMap", "Curvature Map")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_CurvatureMap", "Shows in colours how near a distance is to the curvature limit of the faces"
    )
    ACCEL = "L, U"

    def run(self, doc: Any) -> None:
        """Opens the panel on a new map; OK keeps it, Cancel takes it back."""
        from ..panels.curvature_map import open_new

        open_new(self.create(selected_faces(), doc))

    @staticmethod
    def create(links: List[Link], doc: Any) -> Any:
        """A map of all linked faces, not yet computed; without links it has no base."""
        feature = add_curvature_map(doc)
        feature.Base = rooted_links(links)
        return feature
