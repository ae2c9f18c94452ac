# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits extended faces."""

from typing import Any, List

from ...features.base_face import rooted_links
from ..selection import Link
from . import base
from .base import FacePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(ExtendFacePanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(ExtendFacePanel, feature)


class ExtendFacePanel(FacePanel):
    """Edits one extension."""

    FORM = "ExtendFacePanel"
    LENGTHS = {"length": "Length"}
    CHOICES = {"continuity": "Continuity", "rule": "Rule"}
    TICKS = {"uMin": "UMin", "uMax": "UMax", "vMin": "VMin", "vMax": "VMax"}

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        self._feature.Base = rooted_links(links)
