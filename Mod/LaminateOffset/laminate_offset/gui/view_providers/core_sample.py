# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a core sample looks: a thick line for every ply, in the ply's colour."""

import json
from typing import Any

from ...view_settings import SAMPLE_LOOK
from .base import ResultViewProvider
from .ply_stack import ply_colour


class CoreSampleViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_CoreSample"
    PANEL = "core_sample"
    LOOK = SAMPLE_LOOK

    def __init__(self, vobj: Any):
        super().__init__(vobj)
        vobj.LineWidth = 7.0

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop == "ReportJson" and obj.Status == "ok" and not obj.Shape.isNull():
            plies = json.loads(obj.ReportJson)
            obj.ViewObject.LineColorArray = [ply_colour(obj.Stack, ply["angle"], ply["material"]) for ply in plies]
