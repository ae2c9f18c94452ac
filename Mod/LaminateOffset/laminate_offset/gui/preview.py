# SPDX-License-Identifier: LGPL-2.1-or-later
"""A see-through picture of an offset before it is made.

What is drawn are points of the base, moved along their normals: points of the exact offset, from which the computed one
differs by no more than the tolerance. So a preview costs no mesh of a new surface.
"""

from typing import Any, List, Optional

import FreeCAD as App

from ..features.face_grid import FaceGrid
from ..features.fold_region import FoldRegion
from ..features.offset_limits import Mark
from ..view_settings import OFFSET_LOOK
from .refusal_mark import ORANGE, RED, fold, marks

_LINE = (0.10, 0.22, 0.40)


class Preview:
    """The preview in one 3-D view. It can not be picked."""

    def __init__(self, view: Any):
        self._scene = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._node = None

    def show(self, grids: List[FaceGrid], distance: float, limits: List[Mark]) -> None:
        """Draws the offset of the faces behind the grids at a distance [mm], and where the limits are reached."""
        self.remove()
        if self._scene is None:
            return
        from pivy import coin

        self._node = coin.SoSeparator()
        style, hints = coin.SoPickStyle(), coin.SoShapeHints()
        style.style = coin.SoPickStyle.UNPICKABLE
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        self._node.addChild(style)
        self._node.addChild(hints)
        for grid in grids:
            self._node.addChild(_faces(grid, distance))
            self._node.addChild(_edges(grid, distance))
        self._node.addChild(marks([(limit.point, f"{limit.distance:.4g} mm") for limit in limits], ORANGE))
        self._scene.addChild(self._node)

    def mark(self, where: Optional[Any], word: str, region: Optional[FoldRegion] = None) -> None:
        """Marks the place of a refusal, {"x", "y", "z"} in mm, and the region in which the offset folds."""
        self.remove()
        if self._scene is None or not where:
            return
        from pivy import coin

        self._node = coin.SoSeparator()
        if region is not None and len(region.points):
            self._node.addChild(fold(region.points.tolist(), region.triangles.ravel().tolist()))
        self._node.addChild(marks([(App.Vector(where["x"], where["y"], where["z"]), word)], RED))
        self._scene.addChild(self._node)

    def remove(self) -> None:
        """Takes the picture away. Harmless when there is none."""
        if self._node is not None:
            self._scene.removeChild(self._node)
            self._node = None


def _faces(grid: FaceGrid, distance: float) -> Any:
    from pivy import coin

    node, paint, corners, faces = coin.SoSeparator(), coin.SoMaterial(), coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    paint.diffuseColor = OFFSET_LOOK.colour
    paint.transparency = 0.45
    corners.point.setValues(0, len(grid.points), (grid.points + distance * grid.normals).tolist())
    indices = [index for quad in grid.quads.tolist() for index in (*quad, -1)]
    faces.coordIndex.setValues(0, len(indices), indices)
    for part in (paint, corners, faces):
        node.addChild(part)
    return node


def _edges(grid: FaceGrid, distance: float) -> Any:
    from pivy import coin

    node, light, paint = coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor()
    light.model = coin.SoLightModel.BASE_COLOR
    paint.rgb = _LINE
    node.addChild(light)
    node.addChild(paint)
    for points, normals in grid.edges:
        corners, line = coin.SoCoordinate3(), coin.SoLineSet()
        corners.point.setValues(0, len(points), (points + distance * normals).tolist())
        line.numVertices = len(points)
        node.addChild(corners)
        node.addChild(line)
    return node
