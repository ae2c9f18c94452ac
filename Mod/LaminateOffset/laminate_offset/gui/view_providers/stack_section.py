# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a section of a stack looks: the cut of every ply in the ply's colour, as thick as it is or exaggerated, with its name."""

from typing import Any, List, Sequence, Tuple

import numpy

from ...features.base_face import container_placement
from ...features.plane_section import Cut
from ...features.properties import Property, add_missing
from ...features.stack_section import cuts_of, ply_entries
from ...view_settings import SAMPLE_LOOK
from ..lines import polylines
from ..ply_words import ply_word, ply_words
from ..triangles import triangles
from .base import ResultViewProvider
from .ply_stack import ply_colour

_MODE = "Section"
#: Of the names, in parts of the picture's size: how far from each other, all of them together, and from the cut.
_SPREAD, _MOST_SPREAD, _AWAY = 0.035, 0.5, 0.05
_PROPERTIES = (
    Property(
        "App::PropertyFloat", "Exaggeration", "Section", "How much thicker the plies are drawn; 1: as they are", 1.0
    ),
    Property("App::PropertyBool", "PlyNames", "Section", "Whether the plies' names are written", True),
)


class StackSectionViewProvider(ResultViewProvider):
    """Proxy of the view provider. What is exaggerated is the picture, never the shape."""

    ICON = "LaminateOffset_StackSection"
    PANEL = "stack_section"
    LOOK = SAMPLE_LOOK

    def __init__(self, vobj: Any):
        super().__init__(vobj)
        vobj.DisplayMode = _MODE

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        from pivy import coin

        add_missing(vobj, _PROPERTIES)
        self._picture = coin.SoSeparator()
        vobj.addDisplayMode(self._picture, _MODE)
        super().attach(vobj)

    def restored(self, vobj: Any) -> None:
        """Called when a document has been opened."""
        self._draw(vobj)

    def getDisplayModes(self, _vobj: Any) -> List[str]:
        """Called by FreeCAD for the display modes beside those of a shape."""
        return [_MODE]

    def getDefaultDisplayMode(self) -> str:
        """Called by FreeCAD at creation."""
        return _MODE

    def setDisplayMode(self, mode: str) -> str:
        """Called by FreeCAD with the mode that the user has chosen."""
        return mode

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop == "ReportJson":
            self._draw(obj.ViewObject)

    def onChanged(self, vobj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the view provider has changed."""
        super().onChanged(vobj, prop)
        if prop in ("Exaggeration", "PlyNames") and hasattr(self, "_picture") and not vobj.Object.Document.Restoring:
            self._draw(vobj)

    def _draw(self, vobj: Any) -> None:
        section = vobj.Object
        if not hasattr(section, "Cuts") or section.Status != "ok" or section.Stack is None:
            return  # a refused section keeps its last good picture
        self._picture.removeAllChildren()
        entries, ends = {entry["number"]: entry for entry in ply_entries(section)}, []
        for cut in cuts_of(section):
            entry = entries[cut.number]
            outline = _outline(section, cut, max(vobj.Exaggeration, 0.0))
            self._picture.addChild(_band(outline, ply_colour(section.Stack, entry["angle"], entry["material"])))
            ends.append((outline, ply_word(entry["name"], entry["angle"])))
        if vobj.PlyNames:
            self._picture.addChild(_names(ends))


def _names(cuts: Sequence[Tuple[Any, str]]) -> Any:
    """The names beside the ends of the cuts, evenly spread across them, with a line to each."""
    from pivy import coin

    node, words, leaders = coin.SoSeparator(), [], []
    size = max(float(numpy.ptp(outline, axis=0).max()) for outline, _ in cuts)
    middle = 0.5 * (len(cuts) - 1)
    step = min(_SPREAD, _MOST_SPREAD / len(cuts)) * size
    for index, (outline, word) in enumerate(cuts):
        half = len(outline) // 2
        end = 0.5 * (outline[half - 1] + outline[half])
        along, across = _unit(outline[half - 1] - outline[half - 2]), _unit(outline[half] - outline[half - 1])
        place = end + _AWAY * size * along + (index - middle) * step * across
        words.append((place, word))
        leaders.append(numpy.array([end, place]))
    node.addChild(ply_words(words))
    node.addChild(polylines(leaders))
    return node


def _unit(vector: Any) -> Any:
    return vector / (numpy.linalg.norm(vector) or 1.0)


def _outline(section: Any, cut: Cut, exaggeration: float) -> Any:
    """The cut's corners in the frame of the section's own placement."""
    to_own = section.Placement.inverse().multiply(container_placement(section).inverse()).toMatrix()
    matrix = numpy.array(to_own.A).reshape(4, 4)
    return cut.outline(exaggeration) @ matrix[:3, :3].T + matrix[:3, 3]


def _band(outline: Any, colour: Any) -> Any:
    """The cut of one ply: a band of triangles between bottom and top, and its outline."""
    from pivy import coin

    node, paint, light = coin.SoSeparator(), coin.SoMaterial(), coin.SoLightModel()
    paint.diffuseColor = colour
    light.model = coin.SoLightModel.BASE_COLOR
    half = len(outline) // 2
    corners = []
    for low in range(half - 1):
        high = len(outline) - 1 - low
        corners += [low, low + 1, high - 1, low, high - 1, high]
    for part in (light, paint, triangles(outline.tolist(), corners)):
        node.addChild(part)
    node.addChild(polylines([numpy.concatenate([outline, outline[:1]])]))
    return node
