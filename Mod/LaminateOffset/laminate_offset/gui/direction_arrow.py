# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrow in the 3-D view that shows to which side a face is offset."""

from typing import Any, List, Tuple

import FreeCAD as App
import numpy

from .. import _core

_COLOUR = (0.54, 0.89, 0.20)
_HEAD = 0.3
_RADIUS = 0.035


def anchor(face: Any) -> Tuple[Any, Any]:
    """A point on the face [mm], near its middle and not in a hole, and the outward normal there."""
    u0, u1, v0, v1 = face.ParameterRange
    places = numpy.array([(u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a, b in _SHARES])
    points, normals, inside = _core.evaluate_face(face, places)
    usable = numpy.isfinite(normals).all(axis=1)
    first = next((index for index in range(len(places)) if inside[index] and usable[index]), 0)
    return App.Vector(*points[first]), App.Vector(*normals[first])


def _shares() -> List[Tuple[float, float]]:
    """Places in the unit square, ever finer grids around its middle."""
    shares = []
    for count in (1, 3, 7, 15, 31):
        fractions = sorted(((i + 0.5) / count for i in range(count)), key=lambda f: abs(f - 0.5))
        shares += [(a, b) for b in fractions for a in fractions]
    return shares


_SHARES = _shares()


class DirectionArrow:
    """Arrows in one 3-D view, one a face. They can not be picked."""

    def __init__(self, view: Any):
        self._scene = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._node = None
        self._faces: List[Any] = []
        self._anchors: List[Tuple[Any, Any]] = []

    def show(self, faces: List[Any], distance: float) -> None:
        """Replaces the arrows; distance [mm] gives side and least length."""
        self.remove()
        if self._scene is None or not faces:
            return
        from pivy import coin

        self._node = coin.SoAnnotation()  # drawn over everything: an arrow into a solid would be hidden
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self._node.addChild(style)
        self._find_anchors(faces)
        for face, place in zip(faces, self._anchors):
            self._node.addChild(_arrow(face, place, distance))
        self._scene.addChild(self._node)

    def _find_anchors(self, faces: List[Any]) -> None:
        """The same faces keep theirs: a distance that is being typed must not wait for them."""
        same = len(faces) == len(self._faces) and all(a.isEqual(b) for a, b in zip(faces, self._faces))
        if not same:
            self._faces, self._anchors = faces, [anchor(face) for face in faces]

    def remove(self) -> None:
        """Takes the arrows away. Harmless when there are none."""
        if self._node is not None:
            self._scene.removeChild(self._node)
            self._node = None


def _arrow(face: Any, place: Tuple[Any, Any], distance: float) -> Any:
    from pivy import coin

    point, normal = place
    length = max(abs(distance), 0.15 * face.BoundBox.DiagonalLength)
    direction = normal if distance >= 0 else normal.negative()
    turn = App.Rotation(App.Vector(0, 1, 0), direction)

    node = coin.SoSeparator()
    colour = coin.SoMaterial()
    colour.diffuseColor = _COLOUR
    colour.emissiveColor = tuple(0.4 * part for part in _COLOUR)
    place = coin.SoTransform()
    place.translation.setValue(point.x, point.y, point.z)
    place.rotation.setValue(*turn.Q)
    for part in (colour, place):
        node.addChild(part)
    for part in _shaft_and_head(length):
        node.addChild(part)
    return node


def _shaft_and_head(length: float) -> List[Any]:
    """Along +y from the origin."""
    from pivy import coin

    shaft_length = (1 - _HEAD) * length
    shaft_place, head_place = coin.SoTranslation(), coin.SoTranslation()
    shaft_place.translation.setValue(0, shaft_length / 2, 0)
    head_place.translation.setValue(0, length / 2, 0)
    shaft, head = coin.SoCylinder(), coin.SoCone()
    shaft.radius, shaft.height = _RADIUS * length, shaft_length
    head.bottomRadius, head.height = 3 * _RADIUS * length, _HEAD * length
    return [shaft_place, shaft, head_place, head]
