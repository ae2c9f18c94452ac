# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a plane cuts the plies of a stack: the true cut, on the plies' own surfaces."""

from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy

import laminate_offset as lo

from .. import _core
from ..core_sample import covered
from . import progress
from .contour import plane_curves

#: Steps towards a surface at a distance; each gains some four digits where the stack is thin against the radii.
_STEPS = 5
#: Where the plane's own share of the normal is smaller than this it lies along the face, and cuts nothing.
_ALONG = 0.05

Array = Any  # a numpy array of floats


class Cut(NamedTuple):
    """One piece of a ply's cut: places of the trace, and what the ply is there.

    Attributes:
        number: of the ply, from 1.
        trace, side: arrays (n, 3): points [mm] of the lay-up face in the plane, and in the plane the unit vectors across it,
            to the face's outward side.
        bottom, top: arrays (n,): how far along `side` the ply begins and ends [mm].
    """

    number: int
    trace: Array
    side: Array
    bottom: Array
    top: Array

    def outline(self, exaggeration: float = 1.0) -> Array:
        """The cut's corners (2n, 3), once around: the bottom forwards, the top backwards.

        exaggeration: what the distances from the trace are multiplied with; 1 is the true cut.
        """
        low, high = (self.trace + exaggeration * end[:, None] * self.side for end in (self.bottom, self.top))
        return numpy.concatenate([low, high[::-1]])


def plane_cuts(
    stack: "lo.PlyStack", normal: Array, position: float, cells: int, report: Optional[progress.Report] = None
) -> List[Cut]:
    """The cuts of all plies, from the tool outwards, those of one ply one after another.

    normal: the plane's, of length 1. position: its distance from the origin along the normal [mm]. cells: samples along each
    parameter of the face. Raises OffsetError when report returns False.
    """
    cuts: List[Cut] = []
    traces = [run for uv in plane_curves(stack.base_face, normal, position, cells) for run in _runs(stack, uv, normal)]
    for done, (uv, trace, side) in enumerate(traces):
        reached: Dict[bytes, Array] = {}
        for index, ply in enumerate(stack.plies):
            if report is not None and not report((done + index / len(stack.plies)) / len(traces)):
                raise lo.OffsetError("cancelled", "analysis", "The section was cancelled.")
            cuts += _cuts_of(stack, ply, (uv, trace, side), reached)
    return sorted(cuts, key=lambda cut: cut.number)


def _runs(stack: Any, uv: Array, normal: Array) -> List[Tuple[Array, Array, Array]]:
    """(parameters, points, in-plane directions) along a curve, without the parts where the plane lies along the face."""
    points, normals, _ = _core.evaluate_face(stack.base_face, uv)
    flat = normals - (normals @ normal)[:, None] * normal
    lengths = numpy.linalg.norm(flat, axis=1)
    usable = lengths > _ALONG
    return [
        (uv[part], points[part], flat[part] / lengths[part][:, None])
        for part in _stretches(usable)
        if len(uv[part]) > 1
    ]


def _stretches(good: Array) -> List[slice]:
    """The unbroken stretches in which a condition holds."""
    ends = numpy.flatnonzero(numpy.diff(numpy.concatenate([[0], numpy.asarray(good, dtype=int), [0]])))
    return [slice(first, last) for first, last in zip(ends[::2], ends[1::2])]


def _cuts_of(stack: Any, ply: Any, run: Tuple[Array, Array, Array], reached: Dict[bytes, Array]) -> List[Cut]:
    uv, trace, side = run
    heights = ply.heights(uv)
    ends = [_reach(stack.base_face, ply, which, run, heights[which], reached) for which in range(2)]
    there = covered(ply.base_face, uv) & numpy.isfinite(ends[0]) & numpy.isfinite(ends[1])
    number = ply.ply.number
    return [
        Cut(number, trace[part], side[part], ends[0][part], ends[1][part])
        for part in _stretches(there)
        if len(trace[part]) > 1
    ]


def _reach(
    face: Any, ply: Any, which: int, run: Tuple[Array, Array, Array], first: Array, reached: Dict[bytes, Array]
) -> Array:
    """How far along the in-plane directions the ply's bottom (which 0) or top (1) is. Neighbours share theirs."""
    key = first.tobytes()
    if key not in reached:
        uv, trace, side = run
        _, normals, _ = _core.evaluate_face(face, uv)
        slope = (normals * side).sum(axis=1)
        way = first / slope
        for _ in range(_STEPS):
            points = trace + way[:, None] * side
            feet = lo.nearest_point(face, points)
            normals_there = _core.evaluate_face(face, feet.uv)[1]
            away = ((points - feet.points) * normals_there).sum(axis=1)
            way = way + (ply.heights(feet.uv)[which] - away) / slope
        reached[key] = way
    return reached[key]


def outline_lengths(cuts: Sequence[Cut]) -> Dict[int, float]:
    """The length of every ply's cut along the trace [mm], by its number."""
    lengths: Dict[int, float] = {}
    for cut in cuts:
        length = float(numpy.linalg.norm(numpy.diff(cut.trace, axis=0), axis=1).sum())
        lengths[cut.number] = lengths.get(cut.number, 0.0) + length
    return lengths
