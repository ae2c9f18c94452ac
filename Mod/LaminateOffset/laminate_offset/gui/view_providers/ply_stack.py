# SPDX-License-Identifier: LGPL-2.1-or-later
"""How ply stacks and their plies look: the plies' colours, and the plies below their stack in the tree."""

from typing import Any, List, Mapping

from ...features.exploded import ALONG
from ...features.ply_stack import COLOURS, OUTPUTS, plies_of, ply_reports
from ...features.properties import Property, add_missing
from ...ply_colours import Colour, angle_colour, material_colour
from ...view_settings import OFFSET_LOOK
from ..exploded_picture import EXPLODED, exploded_picture
from ..preferences import angle_colours
from .base import ResultViewProvider

_PROPERTIES = (
    Property(
        "App::PropertyFloat",
        "ExplodedFactor",
        "Exploded",
        "What the plies' distances from the face are multiplied with",
        1.0,
    ),
    Property("App::PropertyEnumeration", "ExplodedAlong", "Exploded", "How the plies are moved", ALONG),
    Property("App::PropertyVector", "ExplodedDirection", "Exploded", "Where to, for one direction", (0.0, 0.0, 1.0)),
)


class PlyStackViewProvider(ResultViewProvider):
    """Proxy of the stack's view provider. The display mode "Exploded" is a picture: it changes no shape."""

    ICON = "LaminateOffset_PlyStack"
    PANEL = "ply_stack"
    LOOK = OFFSET_LOOK

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        from pivy import coin

        add_missing(vobj, _PROPERTIES)
        self._picture = coin.SoSeparator()
        vobj.addDisplayMode(self._picture, EXPLODED)
        super().attach(vobj)

    def restored(self, vobj: Any) -> None:
        """Called when a document has been opened."""
        self._explode(vobj.Object)

    def getDisplayModes(self, _vobj: Any) -> List[str]:
        """Called by FreeCAD for the display modes beside those of a shape."""
        return [EXPLODED]

    def getDefaultDisplayMode(self) -> str:
        """Called by FreeCAD at creation."""
        return "Flat Lines"

    def setDisplayMode(self, mode: str) -> str:
        """Called by FreeCAD with the mode that the user has chosen."""
        return mode

    def onChanged(self, vobj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the view provider has changed."""
        super().onChanged(vobj, prop)
        if prop == "DisplayMode" or prop.startswith("Exploded"):
            self._explode(vobj.Object)

    def claimChildren(self) -> List[Any]:
        """The plies stand below their stack in the tree."""
        return plies_of(self.Object)

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop in ("ReportJson", "Colours"):
            self._paint(obj)
            self._explode(obj)
        elif prop == "Output" and not obj.Document.Restoring:
            # The same surfaces twice would flicker.
            obj.ViewObject.Visibility = obj.Output == OUTPUTS[0]

    def _explode(self, obj: Any) -> None:
        """Draws the exploded plies, where they are asked for."""
        view = obj.ViewObject
        if not hasattr(self, "_picture") or not hasattr(view, "ExplodedDirection"):
            return  # still being made or loaded
        reports = ply_reports(obj)
        if view.DisplayMode != EXPLODED:
            self._picture.removeAllChildren()
        elif reports and not obj.Shape.isNull():  # a refused stack keeps its last good picture
            self._picture.removeAllChildren()
            colours = [ply_colour(obj, report["angle"], report["material"]) for report in reports]
            self._picture.addChild(exploded_picture(obj, view, colours))

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
