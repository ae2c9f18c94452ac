# SPDX-License-Identifier: LGPL-2.1-or-later
"""How feasible limits look: the normal at each place, and the limit in words beside it."""

import math
from typing import Any, List

from ...features.base_face import container_placement
from ...view_settings import LIMITS_LOOK
from ..refusal_mark import ORANGE, marks
from .base import ResultViewProvider


class OffsetLimitsViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_OffsetLimits"
    PANEL = "offset_limits"
    LOOK = LIMITS_LOOK

    def __init__(self, vobj: Any):
        super().__init__(vobj)
        vobj.LineColor = vobj.PointColor = LIMITS_LOOK.colour
        vobj.LineWidth = 3.0

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        super().attach(vobj)
        self._words: List[Any] = []

    def _show_state(self, obj: Any) -> None:
        super()._show_state(obj)
        for node in self._words:
            obj.ViewObject.RootNode.removeChild(node)
        self._words = []
        places = _places(obj) if obj.ViewObject.Visibility else []
        if places:
            self._words = [marks(places, ORANGE)]
            obj.ViewObject.RootNode.insertChild(self._words[0], 0)

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, "Status" if prop == "Places" else prop)


def _places(obj: Any) -> List[Any]:
    limits = [limit.Value for limit in (obj.Negative, obj.Positive) if not math.isnan(limit.Value)]
    to_container = container_placement(obj).inverse()
    return [(to_container.multVec(point), f"{limit:.4g} mm") for point, limit in zip(obj.Places, limits)]
