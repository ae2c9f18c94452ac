# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an offset folds: the part of a face where a factor 1 - d k of a principal curvature k is not positive."""

from typing import Any, Callable, List, NamedTuple, Sequence, TypeVar

import numpy

import laminate_offset as lo

from .. import _core
from .trimmed_grid import Patch, clipped, grid_around, trimmed_grid

_CELLS = 64
#: Finer grids around the place of a refusal, where the first one misses a small region.
_CLOSER = (1 / 64, 1 / 512, 1 / 4096)

_Result = TypeVar("_Result")


class FoldRegion(NamedTuple):
    """Triangles of the base face.

    Attributes:
        points: array (n, 3) [mm].
        triangles: array (m, 3), rows of `points`.
    """

    points: Any
    triangles: Any


def use_of_limit(curvatures: Any, distance: float) -> Any:
    """How much of the feasible distance an offset uses up, as an array (n,): 0 where nothing limits it, 1 and more where it
    folds. NaN counts as 0.

    curvatures: array (n, 2) in 1/mm, of _core.face_curvatures. distance: [mm], signed along the outward normal.
    """
    return numpy.nan_to_num(numpy.maximum(distance * curvatures, 0.0)).max(axis=1)


def fold_region(face: Any, distances: Sequence[float], where: Any = None) -> FoldRegion:
    """The part of a face in which one of the offsets folds, sampled on a grid; empty where none does.

    where: {"u", "v"} of a place that is known to be in it or beside it: a region too small for the grid is sought there.
    """

    def folds(uv: Any) -> Any:
        curvatures = _core.face_curvatures(face, uv)
        return numpy.any([use_of_limit(curvatures, distance) >= 1.0 for distance in distances], axis=0)

    patch = clipped(trimmed_grid(face, _CELLS), folds)
    for share in _CLOSER if where is not None else ():
        if not len(patch.triangles):
            patch = clipped(grid_around(face, (where["u"], where["v"]), share, _CELLS // 2), folds)
    return _placed(face, patch)


def with_fold_region(face: Any, distances: Callable[[], List[float]], work: Callable[[], _Result]) -> _Result:
    """Does the work. Where it is refused because offsets of the face fold, the OffsetError gets `fold_region`."""
    try:
        return work()
    except lo.OffsetError as error:
        if error.status == "curvature-limit":
            error.fold_region = _if_any(face, distances(), error.where)
        raise


def _if_any(face: Any, distances: List[float], where: Any) -> Any:
    """The region; None for a face that cannot be evaluated everywhere: the refusal itself must not be lost."""
    try:
        return fold_region(face, distances, where)
    except lo.OffsetError:
        return None


def _placed(face: Any, patch: Patch) -> FoldRegion:
    if not len(patch.triangles):
        return FoldRegion(numpy.zeros((0, 3)), patch.triangles)
    return FoldRegion(numpy.asarray(_core.evaluate_face(face, patch.uv)[0]), patch.triangles)
