# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks in the 3-D view: a point with a word beside it, drawn over everything, and the region in which an offset folds."""

from typing import Any, List, Sequence, Tuple

from ..features.base_face import container_placement
from .triangles import triangles

RED = (1.0, 0.33, 0.28)
ORANGE = (1.0, 0.66, 0.20)
_SIZE = 15.0
#: So that a fold is red in the shade, too.
_GLOW = 0.4


def marks(places: Sequence[Tuple[Any, str]], colour: Tuple[float, float, float]) -> Any:
    """A node with a filled circle and a word at every place [mm]."""
    from pivy import coin

    node = coin.SoAnnotation()
    style, paint, light = coin.SoPickStyle(), coin.SoBaseColor(), coin.SoLightModel()
    style.style = coin.SoPickStyle.UNPICKABLE
    paint.rgb = colour
    light.model = coin.SoLightModel.BASE_COLOR
    font = coin.SoFont()
    font.name, font.size = "sans", _SIZE
    for part in (style, light, paint, font):
        node.addChild(part)
    for point, text in places:
        node.addChild(_mark(point, text))
    return node


def _mark(point: Any, text: str) -> Any:
    from pivy import coin

    node, place = coin.SoSeparator(), coin.SoTranslation()
    place.translation.setValue(point.x, point.y, point.z)
    corner, dot, word = coin.SoCoordinate3(), coin.SoMarkerSet(), coin.SoText2()
    corner.point.setValue(0, 0, 0)
    dot.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
    word.string = f"  {text}"
    for part in (place, corner, dot, word):
        node.addChild(part)
    return node


def fold(points: Sequence[Any], corners: Sequence[int]) -> Any:
    """A node with the region of a face in which an offset folds, drawn in front of the face and never picked.

    points: [mm]. corners: three of them for every triangle.
    """
    from pivy import coin

    node, paint = triangles(points, corners), coin.SoMaterial()
    paint.diffuseColor = RED
    paint.emissiveColor = tuple(_GLOW * part for part in RED)
    node.insertChild(paint, 0)
    return node


class RefusalMark:
    """The mark of one object: where it was refused, and that what is shown is out of date."""

    def __init__(self, root: Any):
        self._root = root
        self._node = None

    def show(self, obj: Any) -> None:
        """Shows the state of the object; None shows nothing."""
        self.remove()
        places = [] if obj is None else _places(obj)
        if places:
            self._node = _marks_and_fold(obj, places)
            # Before the object's own placement: the places are in the frame of its container.
            self._root.insertChild(self._node, 0)

    def remove(self) -> None:
        """Takes the mark away. Harmless when there is none."""
        if self._node is not None:
            self._root.removeChild(self._node)
            self._node = None


def _marks_and_fold(obj: Any, places: List[Tuple[Any, str]]) -> Any:
    from pivy import coin

    node = coin.SoSeparator()
    points = getattr(obj, "FoldPoints", [])
    if points:
        to_container = container_placement(obj).inverse()
        node.addChild(fold([to_container.multVec(point) for point in points], obj.FoldCorners))
    node.addChild(marks(places, RED))
    return node


def _places(obj: Any) -> List[Tuple[Any, str]]:
    word = f"{obj.Label}: {obj.Status}" + (", out of date" if obj.OutOfDate else "")
    points = list(getattr(obj, "RefusedAt", []))
    to_container = container_placement(obj).inverse()
    places = [(to_container.multVec(point), word) for point in points]
    if not places and obj.OutOfDate:
        places = [(obj.Shape.BoundBox.Center, word)]
    return places
