# SPDX-License-Identifier: LGPL-2.1-or-later
"""A face as triangles over its parameters, cut at its loops: no mesh of FreeCAD's is made, and Python's lock is free while
the engine evaluates the places."""

from typing import Any, Callable, NamedTuple, Tuple

import numpy

from .. import _core

#: Halvings of a side that is cut: a cut is found to 1/256 of a cell.
_HALVINGS = 8

#: Says for parameters (n, 2) which of them belong to a part, as an array (n,).
Test = Callable[[Any], Any]


class Patch(NamedTuple):
    """Triangles in the parameters of a face.

    Attributes:
        uv: array (n, 2).
        triangles: array (m, 3), rows of `uv`.
    """

    uv: Any
    triangles: Any


def trimmed_grid(face: Any, cells: int) -> Patch:
    """A grid of `cells` by `cells` over the parameters of a face, cut at its loops. What is narrower than a cell may be
    left out."""
    u0, u1, v0, v1 = face.ParameterRange
    return clipped(_grid((u0, v0), (u1, v1), cells), inside_of(face))


def grid_around(face: Any, uv: Tuple[float, float], share: float, cells: int) -> Patch:
    """The same around a place, over a share of the parameters' ranges to each side."""
    u0, u1, v0, v1 = face.ParameterRange
    low, high, half = numpy.array((u0, v0)), numpy.array((u1, v1)), share * numpy.array((u1 - u0, v1 - v0))
    return clipped(_grid(numpy.maximum(uv - half, low), numpy.minimum(uv + half, high), cells), inside_of(face))


def inside_of(face: Any) -> Test:
    """The test that says which parameters lie inside the loops of a face."""
    return lambda uv: numpy.asarray(_core.evaluate_face(face, uv)[2], dtype=bool)


def clipped(patch: Patch, test: Test) -> Patch:
    """The part of a patch where a test holds. Sides of triangles are cut where the test changes between their ends."""
    uv, triangles = patch
    if not len(triangles):
        return patch
    kept = numpy.asarray(test(uv), dtype=bool)
    count = kept[triangles].sum(axis=1)
    whole, one, two = (triangles[count == number] for number in (3, 1, 2))
    one, two = _turned(one, kept), _turned(two, ~kept)
    sides = numpy.concatenate([one[:, [0, 1]], one[:, [0, 2]], two[:, [1, 0]], two[:, [2, 0]]])
    cuts, index = numpy.unique(sides, axis=0, return_inverse=True)
    ab, ac, ba, ca = numpy.split(index.reshape(-1) + len(uv), numpy.cumsum([len(one), len(one), len(two)]))
    corners = [numpy.column_stack([one[:, 0], ab, ac])]
    corners += [numpy.column_stack([ba, two[:, 1], two[:, 2]]), numpy.column_stack([ba, two[:, 2], ca])]
    return _used(numpy.concatenate([uv, _cut(uv, cuts, test)]), numpy.concatenate([whole, *corners]))


def _grid(low: Any, high: Any, cells: int) -> Patch:
    u, v = (numpy.linspace(low[axis], high[axis], cells + 1) for axis in range(2))
    uv = numpy.stack(numpy.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
    index = numpy.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:])
    triangles = numpy.concatenate([numpy.stack(corner, axis=-1).reshape(-1, 3) for corner in ((a, b, c), (a, c, d))])
    return Patch(uv, triangles)


def _turned(triangles: Any, single: Any) -> Any:
    """Triangles of which one corner differs from the others, turned so that it comes first."""
    first = single[triangles].argmax(axis=1)
    return triangles[numpy.arange(len(triangles))[:, None], (first[:, None] + numpy.arange(3)) % 3]


def _cut(uv: Any, sides: Any, test: Test) -> Any:
    """On each side from a place where the test holds to one where it does not, the last place where it holds."""
    if not len(sides):
        return numpy.zeros((0, 2))
    holds, fails = uv[sides[:, 0]], uv[sides[:, 1]]
    for _ in range(_HALVINGS):
        middle = 0.5 * (holds + fails)
        good = numpy.asarray(test(middle), dtype=bool)[:, None]
        holds, fails = numpy.where(good, middle, holds), numpy.where(good, fails, middle)
    return holds


def _used(uv: Any, triangles: Any) -> Patch:
    """Without the places that no triangle has."""
    places, index = numpy.unique(triangles, return_inverse=True)
    return Patch(uv[places], index.reshape(-1, 3).astype(int))
