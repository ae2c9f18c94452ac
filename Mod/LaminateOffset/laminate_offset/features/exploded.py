# SPDX-License-Identifier: LGPL-2.1-or-later
"""An exploded picture of a ply stack: every ply at a multiple of its distance from the lay-up face. Nothing of the document is
changed."""

from typing import Any, List, NamedTuple, Optional, Tuple

import FreeCAD as App
import numpy

import laminate_offset as lo

from .. import _core
from .base_face import container_placement, linked_faces
from .ply_stack import ply_reports

#: How the plies are moved.
ALONG = ["normal", "direction"]

#: Height of an exploded stack in parts of the size of its face, where the factor is chosen for the user.
_HEIGHT = 0.5
#: The mean of the unit normals of a face that has a side to look at is longer than this.
_ONE_SIDED = 0.3
#: Coarseness of the picture, in parts of the ply's size.
_DEFLECTION = 0.002
_ON_EDGE = 32


class Sheet(NamedTuple):
    """One ply of the picture, in the document's global frame.

    Attributes:
        points: array (n, 3) [mm].
        triangles: array (m, 3), rows of `points`.
        lines: arrays (k, 3) [mm]: the ply's edges.
    """

    points: Any
    triangles: Any
    lines: List[Any]


def exploded(stack: Any, factor: float, along: str = ALONG[0], direction: Any = (0.0, 0.0, 1.0)) -> List[Sheet]:
    """The sheets of a good ply stack object, from the tool outwards.

    factor: what the plies' distances from the lay-up face are multiplied with; 1 leaves them where they are.
    along: "normal" moves every point along the face's normal below it, "direction" every ply as a whole.
    direction: of "direction"; its length does not count.
    """
    base = base_face(stack)
    placement = container_placement(stack)
    sheets = []
    for shape, level in zip(stack.Shape.childShapes(True, True), levels(stack)):
        placed = shape.copy()  # a mesh is made of it
        placed.Placement = placement.multiply(shape.Placement)
        sheet = _sheet(placed)
        move = (factor - 1.0) * level
        shift = _along_normals(base, sheet, move) if along == ALONG[0] else _all_along(direction, sheet, move)
        sheets.append(shift)
    return sheets


def base_face(stack: Any) -> Any:
    """The lay-up face of a stack object, in the document's global frame. Raises BaseFaceError."""
    return linked_faces(stack.Base)[0][1]


def levels(stack: Any) -> List[float]:
    """The signed distance of what the stack shows of every ply, from the lay-up face [mm]."""
    side = "middle" if stack.Solids else stack.Surface
    return [report[side] for report in ply_reports(stack)]


def usual_factor(stack: Any) -> float:
    """A factor with which all plies can be told apart: the stack is half as high as its face is wide."""
    highest = max((abs(level) for level in levels(stack)), default=0.0)
    return max(1.0, _HEIGHT * stack.Shape.BoundBox.DiagonalLength / highest) if highest else 1.0


def usual_direction(stack: Any) -> Optional[Any]:
    """The mean outward normal of the lay-up face; None for a face that looks to all sides."""
    face = base_face(stack)
    u0, u1, v0, v1 = face.ParameterRange
    shares = (numpy.arange(8) + 0.5) / 8
    places = numpy.array([(u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a in shares for b in shares])
    mean = numpy.nanmean(_core.evaluate_face(face, places)[1], axis=0)
    return App.Vector(*mean).normalize() if numpy.linalg.norm(mean) > _ONE_SIDED else None


def _sheet(shape: Any) -> Sheet:
    corners, triangles = shape.tessellate(_DEFLECTION * shape.BoundBox.DiagonalLength)
    lines = [numpy.array([tuple(point) for point in edge.discretize(_ON_EDGE)]) for edge in _edges(shape)]
    return Sheet(numpy.array([tuple(corner) for corner in corners]), numpy.array(triangles), lines)


def _edges(shape: Any) -> List[Any]:
    return [edge for edge in shape.Edges if not edge.Degenerated]


def _all_along(direction: Any, sheet: Sheet, move: float) -> Sheet:
    unit = numpy.array(tuple(direction), dtype=float)
    shift = move * unit / (numpy.linalg.norm(unit) or 1.0)
    return Sheet(sheet.points + shift, sheet.triangles, [line + shift for line in sheet.lines])


def _along_normals(face: Any, sheet: Sheet, move: float) -> Sheet:
    """Every point along the normal at its foot."""
    sizes = numpy.cumsum([len(sheet.points), *(len(line) for line in sheet.lines)])[:-1]
    points = numpy.concatenate([sheet.points, *sheet.lines])
    moved = points + move * _core.evaluate_face(face, lo.nearest_point(face, points).uv)[1]
    parts: Tuple[Any, ...] = tuple(numpy.split(moved, sizes))
    return Sheet(parts[0], sheet.triangles, list(parts[1:]))
