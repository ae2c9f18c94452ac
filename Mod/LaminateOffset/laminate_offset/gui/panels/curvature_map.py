# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits curvature maps."""

from typing import Any, List

from ...features.base_face import rooted_links
from ..selection import Link
from . import base
from .base import FacePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(CurvatureMapPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(CurvatureMapPanel, feature)


class CurvatureMapPanel(FacePanel):
    """Edits one map. It is drawn at once where there is a face."""

    FORM = "CurvatureMapPanel"
    LENGTHS = {"distance": "Distance"}
    CHOICES = {"shows": "Shows"}

    def start(self) -> None:
        """The map is drawn at once where there is a face."""
        super().start()
        if self.has_base():
            self.compute()

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        self._feature.Base = rooted_links(links)

    def faces_changed(self) -> None:
        """Other faces are picked than before."""
        self.show_faces()
        if self.has_base():
            self.compute()
