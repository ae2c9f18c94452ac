# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a rosette looks: the first axis red, the second green, the normal blue, as FreeCAD's own axes; its name beside it."""

from typing import Any

from ...view_settings import LIMITS_LOOK
from ..lines import polylines
from ..ply_words import ply_words
from .base import ResultViewProvider

_COLOURS = ((0.85, 0.12, 0.10), (0.10, 0.60, 0.15), (0.15, 0.30, 0.85))
_WIDTH = 4.0


class RosetteViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_Rosette"
    PANEL = "rosette"
    LOOK = LIMITS_LOOK

    def __init__(self, vobj: Any):
        super().__init__(vobj)
        vobj.LineWidth = _WIDTH
        vobj.PointSize = 1.0

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        super().attach(vobj)
        self._axes: Any = None

    def restored(self, vobj: Any) -> None:
        """Called when a document has been opened."""
        self._show_state(vobj.Object)

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, "Status" if prop in ("ReportJson", "Label") else prop)
        if prop == "ReportJson" and obj.Status == "ok" and not obj.Shape.isNull():
            obj.ViewObject.LineColorArray = list(_COLOURS[: len(obj.Shape.Edges)])

    def _show_state(self, obj: Any) -> None:
        super()._show_state(obj)
        if self._axes is not None:
            obj.ViewObject.RootNode.removeChild(self._axes)
            self._axes = None
        if obj.ViewObject.Visibility and getattr(obj, "Status", "") == "ok" and not obj.Shape.isNull():
            self._axes = _drawn(obj)
            # Before the object's own placement: the shape comes in the frame of its container.
            obj.ViewObject.RootNode.insertChild(self._axes, 0)


def _drawn(obj: Any) -> Any:
    """The axes and the name over everything: in a hollow the axes themselves would be hidden."""
    from pivy import coin

    node = coin.SoAnnotation()
    axes = [[vertex.Point for vertex in edge.Vertexes] for edge in obj.Shape.Edges]
    for axis, colour in zip(axes, _COLOURS):
        node.addChild(polylines([axis], colour, _WIDTH))
    node.addChild(ply_words([(axes[0][1], obj.Label)]))
    return node
