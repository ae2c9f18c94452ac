# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curves in which a plane cuts a face, as places in the face's parameters."""

from collections import defaultdict
from typing import Any, Callable, Dict, List

import numpy

from .. import _core
from .trimmed_grid import Patch, trimmed_grid

#: Steps of the search on a side of a triangle; it converges faster than by halves.
_STEPS = 12

#: Points of a curve nearer than this part of their mean distance are one.
_NEAREST = 0.05

#: Signed values at parameters (n, 2), as an array (n,).
Height = Callable[[Any], Any]


def plane_curves(face: Any, normal: Any, position: float, cells: int) -> List[Any]:
    """The curves in which the plane {p: p . normal = position} cuts a face, inside its loops.

    normal: of length 1. position: [mm]. cells: samples along each parameter; what is smaller than a cell may be missed.
    Returns for every curve an array (n, 2) of parameters of points of the plane, in their order.
    """

    def height(uv: Any) -> Any:
        return _core.evaluate_face(face, uv)[0] @ normal - position

    return zero_curves(trimmed_grid(face, cells), height)


def zero_curves(patch: Patch, height: Height) -> List[Any]:
    """The curves on which a function over a patch is zero, as arrays (n, 2) of parameters."""
    if not len(patch.triangles):
        return []
    values = height(patch.uv)
    above = values >= 0.0
    mixed = patch.triangles[(above[patch.triangles].any(axis=1)) & ~above[patch.triangles].all(axis=1)]
    if not len(mixed):
        return []
    pairs = numpy.stack([mixed, numpy.roll(mixed, -1, axis=1)], axis=-1)
    cut = above[pairs[..., 0]] != above[pairs[..., 1]]  # two sides of every mixed triangle
    sides, index = numpy.unique(numpy.sort(pairs[cut], axis=1), axis=0, return_inverse=True)
    places = _zeros(patch.uv, sides, values, height)
    curves = [_spaced(places[chain]) for chain in _chains(index.reshape(-1, 2))]
    return [curve for curve in curves if len(curve) > 1]


def _zeros(uv: Any, sides: Any, values: Any, height: Height) -> Any:
    """On every side the place where the function is zero, by the Illinois method."""
    a, b = uv[sides[:, 0]], uv[sides[:, 1]]
    fa, fb = values[sides[:, 0]], values[sides[:, 1]]
    for _ in range(_STEPS):
        share = numpy.divide(fa, fa - fb, out=numpy.full_like(fa, 0.5), where=fa != fb)
        middle = a + share[:, None] * (b - a)
        f = height(middle)
        same = (f >= 0.0) == (fb >= 0.0)
        # The end that stays for the second time counts half: without that it would stay for ever.
        a, fa = numpy.where(same[:, None], a, b), numpy.where(same, 0.5 * fa, fb)
        b, fb = middle, f
    return b


def _spaced(places: Any) -> Any:
    """Without points that all but coincide with the one before: such stand beside the grid's own points."""
    steps = numpy.linalg.norm(numpy.diff(places, axis=0) / (numpy.ptp(places, axis=0).max() or 1.0), axis=1)
    kept, gone = [0], 0.0
    for index, step in enumerate(steps, start=1):
        gone += step
        if gone > _NEAREST * steps.mean():
            kept.append(index)
            gone = 0.0
    if kept[-1] != len(places) - 1 and len(kept) > 1:
        kept[-1] = len(places) - 1  # the curve ends where it ended
    return places[kept]


def _chains(segments: Any) -> List[List[int]]:
    """Points joined by segments, in their order; a closed chain ends with its first point."""
    neighbours: Dict[int, List[int]] = defaultdict(list)
    for first, second in segments.tolist():
        neighbours[first].append(second)
        neighbours[second].append(first)
    chains = []
    ends = [point for point, others in neighbours.items() if len(others) == 1]
    for start in [*ends, *list(neighbours)]:
        chain = [start]
        while neighbours[chain[-1]]:
            following = neighbours[chain[-1]].pop()
            neighbours[following].remove(chain[-1])
            chain.append(following)
        if len(chain) > 1:
            chains.append(chain)
    return chains
