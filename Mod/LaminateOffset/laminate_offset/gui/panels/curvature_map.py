# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits curvature maps."""

from typing import Any

from . import base
from .base import QuickFacePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(CurvatureMapPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(CurvatureMapPanel, feature)


class CurvatureMapPanel(QuickFacePanel):
    """Edits one map. It is drawn at once where there is a face."""

    FORM = "CurvatureMapPanel"
    LENGTHS = {"distance": "Distance"}
    CHOICES = {"shows": "Shows"}
