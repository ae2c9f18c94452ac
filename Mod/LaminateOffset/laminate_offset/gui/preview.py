# SPDX-License-Identifier: LGPL-2.1-or-later
"""A see-through picture of an offset before it is made.

What is drawn is the base's mesh, its corners moved along their normals: the exact offset at these points, from which the
computed one differs by no more than the tolerance. So a preview costs no mesh of a new surface.
"""

from typing import Any, List, Optional, Tuple

import FreeCAD as App
import numpy

from ..view_settings import OFFSET_LOOK
from .refusal_mark import RED, marks

#: Coarser than this a mesh is refined; finer ones are taken as FreeCAD's view has made them (share of the diagonal).
_DEFLECTION = 0.01


class Preview:
    """The preview in one 3-D view. It can not be picked."""

    def __init__(self, view: Any):
        self._scene = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._node = None
        self._faces: List[Any] = []
        self._meshes: List[Tuple[Any, Any, Any]] = []

    def prepare(self, faces: List[Any]) -> None:
        """Reads the meshes of the base faces, unless they are the same as before."""
        same = len(faces) == len(self._faces) and all(a.isEqual(b) for a, b in zip(faces, self._faces))
        if self._scene is not None and not same:
            self._faces = faces
            self._meshes = [_mesh(face) for face in faces]

    def show(self, distance: float) -> None:
        """Draws the offset at a distance [mm]."""
        self.remove()
        if self._scene is None:
            return
        from pivy import coin

        self._node = coin.SoSeparator()
        style, paint, hints = coin.SoPickStyle(), coin.SoMaterial(), coin.SoShapeHints()
        style.style = coin.SoPickStyle.UNPICKABLE
        paint.diffuseColor = OFFSET_LOOK.colour
        paint.transparency = 0.45
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        for part in (style, paint, hints):
            self._node.addChild(part)
        for points, normals, indices in self._meshes:
            corners, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
            corners.point.setValues(0, len(points), (points + distance * normals).tolist())
            faces.coordIndex.setValues(0, len(indices), indices)
            self._node.addChild(corners)
            self._node.addChild(faces)
        self._scene.addChild(self._node)

    def mark(self, where: Optional[Any], word: str) -> None:
        """Marks the place of a refusal, {"x", "y", "z"} in mm."""
        self.remove()
        if self._scene is not None and where:
            self._node = marks([(App.Vector(where["x"], where["y"], where["z"]), word)], RED)
            self._scene.addChild(self._node)

    def remove(self) -> None:
        """Takes the picture away. Harmless when there is none."""
        if self._node is not None:
            self._scene.removeChild(self._node)
            self._node = None


def _mesh(face: Any) -> Tuple[Any, Any, List[int]]:
    """Corners (n, 3) [mm], their outward normals (n, 3), and Coin's indices of the triangles."""
    corners, triangles = face.tessellate(_DEFLECTION * face.BoundBox.DiagonalLength)
    points = numpy.array([tuple(corner) for corner in corners])
    normals = numpy.array([tuple(_normal(face, corner)) for corner in corners])
    indices = [index for triangle in triangles for index in (*triangle, -1)]
    return points, normals, indices


def _normal(face: Any, point: Any) -> Any:
    return face.normalAt(*face.Surface.parameter(point))
