# SPDX-License-Identifier: LGPL-2.1-or-later
"""What maps have in common: a surface in colours, and a legend at the left of the view."""

from typing import Any, List, NamedTuple, Sequence

from ..legend import Colour, legend
from ..triangles import triangles
from .base import ResultViewProvider


class Scale(NamedTuple):
    """Attributes:
    title: above the legend.
    ticks: the legend's figures, from the top down.
    colours: of evenly spaced values from 0 to 1, which stand at the bottom and at the top.
    """

    title: str
    ticks: Sequence[str]
    colours: Sequence[Colour]


class ColourMapViewProvider(ResultViewProvider):
    """Proxy of the view provider of an object with the properties Points and Corners."""

    #: The properties that are drawn: the last one to be set.
    DRAWN: Sequence[str] = ()

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        from pivy import coin

        self._map = coin.SoSeparator()
        vobj.addDisplayMode(self._map, "Map")
        super().attach(vobj)
        self._draw(vobj.Object)

    def getDisplayModes(self, _vobj: Any) -> List[str]:
        """Called by FreeCAD for the list of display modes."""
        return ["Map"]

    def getDefaultDisplayMode(self) -> str:
        """Called by FreeCAD at creation."""
        return "Map"

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        super().updateData(obj, prop)
        if prop in self.DRAWN:
            self._draw(obj)

    def shares(self, obj: Any) -> Sequence[float]:
        """A value from 0 to 1 for every point; none where nothing can be drawn."""
        raise NotImplementedError

    def scale(self, obj: Any) -> Scale:
        """What the values mean."""
        raise NotImplementedError

    def _draw(self, obj: Any) -> None:
        self._map.removeAllChildren()
        shares = self.shares(obj)
        if not len(shares) or len(shares) != len(obj.Points):
            return
        scale = self.scale(obj)
        self._map.addChild(triangles(obj.Points, obj.Corners, [_colour(share, scale.colours) for share in shares]))
        self._map.addChild(legend(scale.title, scale.ticks, list(reversed(scale.colours))))


def _colour(share: float, colours: Sequence[Colour]) -> Colour:
    """The colour of a share from 0 to 1, with even changes between the given ones."""
    place = min(max(share, 0.0), 1.0) * (len(colours) - 1)
    index = min(int(place), len(colours) - 2)
    low, high = colours[index], colours[index + 1]
    rest = place - index
    mixed = tuple((1.0 - rest) * a + rest * b for a, b in zip(low, high))
    return (mixed[0], mixed[1], mixed[2])
