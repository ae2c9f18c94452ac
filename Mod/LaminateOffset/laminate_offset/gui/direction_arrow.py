# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arrow in the 3-D view that shows to which side a face is offset."""

from typing import Any, List, Tuple

import FreeCAD as App
import numpy

from .. import _core
from .scene import scene_graph

_COLOUR = (0.54, 0.89, 0.20)
_HEAD = 0.3
_RADIUS = 0.035

#: Places along each parameter at which a point inside the loops is sought, one grid after the other.
_GRIDS = (1, 3, 7, 15, 31)


def anchor(face: Any) -> Tuple[Any, Any]:
    """A point on the face [mm], near its middle and not in a hole, and the outward normal there."""
    u0, u1, v0, v1 = face.ParameterRange
    for count in _GRIDS:
        places = numpy.array([(u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a, b in _shares(count)])
        points, normals, inside = _core.evaluate_face(face, places)
        usable = numpy.flatnonzero(numpy.asarray(inside) & numpy.isfinite(normals).all(axis=1))
        if usable.size or count == _GRIDS[-1]:
            break
    first = int(usable[0]) if usable.size else 0
    return App.Vector(*points[first]), App.Vector(*normals[first])


def _shares(count: int) -> List[Tuple[float, float]]:
    """A grid in the unit square, from its middle outwards."""
    fractions = sorted(((i + 0.5) / count for i in range(count)), key=lambda f: abs(f - 0.5))
    return [(a, b) for b in fractions for a in fractions]


class DirectionArrow:
    """Arrows in one 3-D view, one a face. They can not be picked."""

    def __init__(self, view: Any):
        self._scene = scene_graph(view)
        self._node = None
        self._arrows: List["_Arrow"] = []
        self._faces: List[Any] = []

    def show(self, faces: List[Any], distance: float) -> None:
        """Shows the arrows of these faces; distance [mm] gives side and least length."""
        if self._scene is None:
            return
        same = len(faces) == len(self._faces) and all(a.isEqual(b) for a, b in zip(faces, self._faces))
        if not same or self._node is None:
            self.remove()
            # The same faces keep theirs: a distance that is being typed must not wait for them.
            self._arrows = self._arrows if same else [_Arrow(face) for face in faces]
            self._faces = faces
            self._add()
        for arrow in self._arrows:
            arrow.point_along(distance)

    def remove(self) -> None:
        """Takes the arrows away. Harmless when there are none."""
        if self._node is not None:
            self._scene.removeChild(self._node)
            self._node = None

    def _add(self) -> None:
        if not self._arrows:
            return
        from pivy import coin

        self._node = coin.SoAnnotation()  # drawn over everything: an arrow into a solid would be hidden
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self._node.addChild(style)
        for arrow in self._arrows:
            self._node.addChild(arrow.node)
        self._scene.addChild(self._node)


class _Arrow:
    """The arrow of one face. What costs time is done once; a new distance turns and scales it.

    Attributes:
        node: draws it.
    """

    def __init__(self, face: Any):
        from pivy import coin

        point, self._normal = anchor(face)
        self._least = 0.15 * face.BoundBox.DiagonalLength
        self._shown: Any = None
        self.node = coin.SoSeparator()
        colour, self._place = coin.SoMaterial(), coin.SoTransform()
        colour.diffuseColor = _COLOUR
        colour.emissiveColor = tuple(0.4 * part for part in _COLOUR)
        self._place.translation.setValue(point.x, point.y, point.z)
        for part in (colour, self._place, *_shaft_and_head()):
            self.node.addChild(part)

    def point_along(self, distance: float) -> None:
        """To the side of a signed distance [mm], as long as it is but not too short."""
        length, outwards = max(abs(distance), self._least), distance >= 0
        if self._shown == (length, outwards):
            return  # every change draws the whole view anew
        self._shown = (length, outwards)
        turn = App.Rotation(App.Vector(0, 1, 0), self._normal if outwards else self._normal.negative())
        self._place.rotation.setValue(*turn.Q)
        self._place.scaleFactor.setValue(length, length, length)


def _shaft_and_head() -> List[Any]:
    """Along +y from the origin, of length 1."""
    from pivy import coin

    shaft_place, head_place = coin.SoTranslation(), coin.SoTranslation()
    shaft_place.translation.setValue(0, (1 - _HEAD) / 2, 0)
    head_place.translation.setValue(0, 0.5, 0)
    shaft, head = coin.SoCylinder(), coin.SoCone()
    shaft.radius, shaft.height = _RADIUS, 1 - _HEAD
    head.bottomRadius, head.height = 3 * _RADIUS, _HEAD
    return [shaft_place, shaft, head_place, head]
