# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a deviation map looks: the offset in colours, and a legend at the left of the view."""

from typing import Any, List, Sequence, Tuple

from ..legend import Colour, legend
from .base import ResultViewProvider

#: From the most negative deviation through none to the most positive one.
_SCALE: Sequence[Colour] = (
    (0.13, 0.31, 0.70),
    (0.55, 0.73, 0.90),
    (0.97, 0.97, 0.94),
    (0.96, 0.65, 0.48),
    (0.73, 0.10, 0.16),
)


class DeviationMapViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_DeviationMap"

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
        if prop == "Deviations":
            self._draw(obj)

    def _draw(self, obj: Any) -> None:
        self._map.removeAllChildren()
        values = obj.Deviations if hasattr(obj, "Deviations") else []
        if not values or len(values) != len(obj.Points):
            return
        extreme = max(map(abs, values)) or 1.0
        self._map.addChild(_surface(obj.Points, obj.Corners, [_colour(value / extreme) for value in values]))
        ticks = [f"{extreme:.3g} mm", f"{extreme / 2:.3g}", "0", f"{-extreme / 2:.3g}", f"{-extreme:.3g} mm"]
        self._map.addChild(legend("Deviation", ticks, list(reversed(_SCALE))))


def _colour(share: float) -> Colour:
    """The colour of a share from -1 to 1."""
    place = (share + 1.0) / 2.0 * (len(_SCALE) - 1)
    index = min(int(place), len(_SCALE) - 2)
    low, high = _SCALE[index], _SCALE[index + 1]
    rest = place - index
    mixed = tuple((1.0 - rest) * a + rest * b for a, b in zip(low, high))
    return (mixed[0], mixed[1], mixed[2])


def _surface(points: Sequence[Any], corners: Sequence[int], colours: Sequence[Tuple[float, float, float]]) -> Any:
    """The mesh, drawn in front of the offset that it lies on."""
    from pivy import coin

    node, paint, bind, place = coin.SoSeparator(), coin.SoMaterial(), coin.SoMaterialBinding(), coin.SoCoordinate3()
    hints, shift, faces = coin.SoShapeHints(), coin.SoPolygonOffset(), coin.SoIndexedFaceSet()
    paint.diffuseColor.setValues(0, len(colours), list(colours))
    bind.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    shift.factor, shift.units = -2.0, -2.0
    place.point.setValues(0, len(points), [tuple(point) for point in points])
    indices = [index for start in range(0, len(corners), 3) for index in (*corners[start : start + 3], -1)]
    faces.coordIndex.setValues(0, len(indices), indices)
    for part in (hints, shift, paint, bind, place, faces):
        node.addChild(part)
    return node
