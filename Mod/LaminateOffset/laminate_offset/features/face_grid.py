# SPDX-License-Identifier: LGPL-2.1-or-later
"""A quick picture of a face: a grid over its parameters where it lies inside the loops, and its edges."""

from typing import Any, List, NamedTuple, Tuple

import numpy

from .. import _core

_CELLS = 48
_ON_EDGE = 48


class FaceGrid(NamedTuple):
    """Points of a face and its outward normals there.

    Attributes:
        points, normals: arrays (n, 3) [mm] of the grid.
        quads: array (m, 4), rows of `points`: the cells whose corners all lie inside the loops.
        edges: (points, normals) along every edge.
    """

    points: Any
    normals: Any
    quads: Any
    edges: List[Tuple[Any, Any]]


def face_grid(face: Any) -> FaceGrid:
    """The grid of a face, from milliseconds of work and without a mesh of FreeCAD's."""
    u0, u1, v0, v1 = face.ParameterRange
    u, v = numpy.meshgrid(numpy.linspace(u0, u1, _CELLS + 1), numpy.linspace(v0, v1, _CELLS + 1), indexing="ij")
    points, normals, inside = _core.evaluate_face(face, numpy.column_stack([u.ravel(), v.ravel()]))
    usable = numpy.asarray(inside) & numpy.isfinite(normals).all(axis=1)
    index = numpy.arange((_CELLS + 1) ** 2).reshape(_CELLS + 1, _CELLS + 1)
    quads = numpy.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], axis=-1).reshape(-1, 4)
    return FaceGrid(points, normals, quads[usable[quads].all(axis=1)], [_along(face, edge) for edge in face.Edges])


def _along(face: Any, edge: Any) -> Tuple[Any, Any]:
    curve, first, last = face.curveOnSurface(edge)
    places = [curve.value(t) for t in numpy.linspace(first, last, _ON_EDGE + 1)]
    points, normals, _ = _core.evaluate_face(face, numpy.array([(place.x, place.y) for place in places]))
    usable = numpy.isfinite(normals).all(axis=1)
    return points[usable], normals[usable]
