# SPDX-License-Identifier: LGPL-2.1-or-later
"""How ply stacks and their plies look: the plies' colours, and the plies below their stack in the tree."""

from typing import Any, List, Mapping

from ...features.ply_stack import COLOURS, OUTPUTS, plies_of, ply_reports
from ...ply_colours import Colour, angle_colour, material_colour
from ...view_settings import OFFSET_LOOK
from ..preferences import angle_colours
from .base import ResultViewProvider


class PlyStackViewProvider(ResultViewProvider):
    """Proxy of the stack's view provider."""

    ICON = "LaminateOffset_PlyStack"
    PANEL = "ply_stack"
    LOOK = OFFSET_LOOK

    def claimChildren(self) -> List[Any]:
        """The plies stand below their stack in the tree."""
        return plies_of(self.Object)

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop in ("ReportJson", "Colours"):
            self._paint(obj)
        elif prop == "Output":
            # The same surfaces twice would flicker.
            obj.ViewObject.Visibility = obj.Output == OUTPUTS[0]

    def _paint(self, obj: Any) -> None:
        reports = ply_reports(obj)
        if not reports or obj.Shape.isNull():
            return
        plies = obj.Shape.childShapes(True, True)
        colours = [ply_colour(obj, report["angle"], report["material"]) for report in reports]
        obj.ViewObject.DiffuseColor = [colour for colour, ply in zip(colours, plies) for _ in ply.Faces]
        for ply in plies_of(obj):
            paint_ply(ply)


class PlyViewProvider(ResultViewProvider):
    """Proxy of one ply's view provider."""

    ICON = "LaminateOffset_Ply"
    LOOK = OFFSET_LOOK

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop == "ReportJson":
            paint_ply(obj)


def paint_ply(ply: Any) -> None:
    """Gives a ply the colour that its stack's choice asks for."""
    if ply.Stack is not None and ply.Status == "ok":
        ply.ViewObject.ShapeColor = ply_colour(ply.Stack, ply.FibreAngle.Value, ply.Material)


def ply_colour(stack: Any, angle: float, material: str) -> Colour:
    """The colour of a ply as its stack asks for it."""
    if stack.Colours == COLOURS[1]:
        return material_colour(material)
    chosen: Mapping[float, Colour] = angle_colours()
    return angle_colour(angle, chosen)
