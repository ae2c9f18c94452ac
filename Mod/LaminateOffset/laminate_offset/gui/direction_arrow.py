# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrow in the 3-D view that shows to which side a face is offset."""

from typing import Any, List, Tuple

import FreeCAD as App

_COLOUR = (0.54, 0.89, 0.20)
_HEAD = 0.3
_RADIUS = 0.035


def anchor(face: Any) -> Tuple[Any, Any]:
    """A point on the face [mm], near its middle and not in a hole, and the outward normal there."""
    u, v = face.Surface.parameter(face.CenterOfMass)
    if not face.isPartOfDomain(u, v):
        u, v = _inside(face)
    return face.valueAt(u, v), face.normalAt(u, v)


def _inside(face: Any) -> Tuple[float, float]:
    """Parameters of a point inside the loops: the first hit of ever finer grids, else the middle of the range."""
    u0, u1, v0, v1 = face.ParameterRange
    for count in (1, 3, 7, 15, 31):
        fractions = sorted(((i + 0.5) / count for i in range(count)), key=lambda f: abs(f - 0.5))
        for fv in fractions:
            for fu in fractions:
                u, v = u0 + fu * (u1 - u0), v0 + fv * (v1 - v0)
                if face.isPartOfDomain(u, v):
                    return u, v
    return (u0 + u1) / 2, (v0 + v1) / 2


class DirectionArrow:
    """Arrows in one 3-D view, one a face. They can not be picked."""

    def __init__(self, view: Any):
        self._scene = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._node = None

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
        for face in faces:
            self._node.addChild(_arrow(face, distance))
        self._scene.addChild(self._node)

    def remove(self) -> None:
        """Takes the arrows away. Harmless when there are none."""
        if self._node is not None:
            self._scene.removeChild(self._node)
            self._node = None


def _arrow(face: Any, distance: float) -> Any:
    from pivy import coin

    point, normal = anchor(face)
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
