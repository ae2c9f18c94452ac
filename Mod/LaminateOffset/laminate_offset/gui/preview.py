# SPDX-License-Identifier: LGPL-2.1-or-later
"""A see-through picture of an offset before it is made.

What is drawn are points of the base, moved along their normals: points of the exact offset, from which the computed one
differs by no more than the tolerance. So a preview costs no mesh of a new surface.
"""

from typing import Any, List, NamedTuple, Optional

import FreeCAD as App
import numpy

from ..features.face_grid import FaceGrid
from ..features.fold_region import FoldRegion
from ..features.offset_limits import Mark
from ..view_settings import OFFSET_LOOK
from .refusal_mark import ORANGE, RED, fold, marks
from .scene import scene_graph

_LINE = (0.10, 0.22, 0.40)


class Drawing(NamedTuple):
    """Plain lists, as the scene takes them.

    Attributes:
        points, indices: of the facets; each facet's indices end with -1.
        corners, lengths: of the lines; how many corners each line has.
    """

    points: List[List[float]]
    indices: List[int]
    corners: List[List[float]]
    lengths: List[int]


class Preview:
    """The preview in one 3-D view. It can not be picked."""

    def __init__(self, view: Any):
        self._scene = scene_graph(view)
        self._node = None

    def show(self, pictures: List[Drawing], limits: List[Mark]) -> None:
        """Draws the pictures, and where the limits are reached."""
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
        for picture in pictures:
            self._node.addChild(_faces(picture))
            self._node.addChild(_edges(picture))
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


def drawing(grid: FaceGrid, distance: float) -> Drawing:
    """What is drawn of the offset of the face behind a grid at a distance [mm]. Made in the worker: the GUI's thread only hands
    it to the scene."""
    corners = numpy.column_stack([grid.quads, numpy.full(len(grid.quads), -1)])
    lines = [points + distance * normals for points, normals in grid.edges]
    return Drawing(
        (grid.points + distance * grid.normals).tolist(),
        corners.ravel().tolist(),
        numpy.concatenate([numpy.zeros((0, 3)), *lines]).tolist(),
        [len(line) for line in lines],
    )


def _faces(picture: Drawing) -> Any:
    from pivy import coin

    node, paint, corners, faces = coin.SoSeparator(), coin.SoMaterial(), coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    paint.diffuseColor = OFFSET_LOOK.colour
    paint.transparency = 0.45
    corners.point.setValues(0, len(picture.points), picture.points)
    faces.coordIndex.setValues(0, len(picture.indices), picture.indices)
    for part in (paint, corners, faces):
        node.addChild(part)
    return node


def _edges(picture: Drawing) -> Any:
    from pivy import coin

    node, light, paint = coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor()
    corners, lines = coin.SoCoordinate3(), coin.SoLineSet()
    light.model = coin.SoLightModel.BASE_COLOR
    paint.rgb = _LINE
    corners.point.setValues(0, len(picture.corners), picture.corners)
    lines.numVertices.setValues(0, len(picture.lengths), picture.lengths)
    for part in (light, paint, corners, lines):
        node.addChild(part)
    return node
