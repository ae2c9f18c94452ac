# SPDX-License-Identifier: LGPL-2.1-or-later
"""Core samples and thickness of a stack: which plies lie where, along the normals of the lay-up face."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import FreeCAD
import numpy

from . import _core
from .api import nearest_point

if TYPE_CHECKING:
    from .stack import PlyStack, StackPly

# How far from a face's edges a place counts as one on them: in mm, and in parts of the face's size.
ON_EDGE = 1e-6
ON_EDGE_RELATIVE = 1e-9
# How far from the normal in its foot a point counts as one on it, in mm and in parts of its distance from the foot.
ON_NORMAL = 1e-6


@dataclass(frozen=True)
class CoreLayer:
    """One ply in a core sample.

    Attributes:
        ply: the StackPly.
        bottom, top: signed distances in mm of its sides from the lay-up face along the outward normal.
        start, end: the points of the two sides on the normal, in mm.
    """

    ply: "StackPly"
    bottom: float
    top: float
    start: "FreeCAD.Vector"
    end: "FreeCAD.Vector"

    @property
    def thickness(self) -> float:
        """In mm, along the normal."""
        return abs(self.top - self.bottom)


@dataclass(frozen=True)
class CoreSample:
    """The plies along the normal through one place.

    Attributes:
        point: the point that was asked for, in mm.
        uv: parameters of the nearest point of the lay-up face.
        foot: that point, in mm.
        normal: the face's outward normal there, of length 1.
        layers: a CoreLayer for every ply there, from the tool outwards; none beside the face.
    """

    point: "FreeCAD.Vector"
    uv: Tuple[float, float]
    foot: "FreeCAD.Vector"
    normal: "FreeCAD.Vector"
    layers: Tuple[CoreLayer, ...]

    @property
    def thickness(self) -> float:
        """Of all plies there, in mm."""
        return sum(layer.thickness for layer in self.layers)


def core_samples(stack: "PlyStack", points: Any) -> List[CoreSample]:
    """A CoreSample for every row of an (n, 3) array of points in mm."""
    asked = _rows(points, 3, "points")
    uv = nearest_point(stack.base_face, asked).uv
    feet, normals, _ = _core.evaluate_face(stack.base_face, uv)
    levels = _levels(stack, uv, _beside(stack.base_face, asked, uv))
    samples = []
    for i, point in enumerate(asked):
        foot, normal = FreeCAD.Vector(*feet[i]), FreeCAD.Vector(*normals[i])
        layers = [
            CoreLayer(ply, float(bottom[i]), float(top[i]), foot + normal * bottom[i], foot + normal * top[i])
            for ply, (bottom, top) in zip(stack.plies, levels)
            if numpy.isfinite(bottom[i]) and bottom[i] != top[i]
        ]
        place = (float(uv[i, 0]), float(uv[i, 1]))
        samples.append(CoreSample(FreeCAD.Vector(*point), place, foot, normal, tuple(layers)))
    return samples


def stack_thickness(stack: "PlyStack", places: Any) -> "numpy.ndarray[Any, Any]":
    """The thickness of a stack at parameters (n, 2) or at the feet of points (n, 3), as an array (n,)."""
    rows = numpy.asarray(places, dtype=float)
    beside = numpy.zeros(len(rows) if rows.ndim else 0, dtype=bool)
    if rows.ndim == 2 and rows.shape[1] == 3:
        asked, rows = rows, nearest_point(stack.base_face, rows).uv
        beside = _beside(stack.base_face, asked, rows)
    uv = _rows(rows, 2, "places")
    total = numpy.zeros(len(uv))
    for bottom, top in _levels(stack, uv, beside):
        total += numpy.nan_to_num(numpy.abs(top - bottom))
    return total


def covered(face: Any, uv: Any) -> "numpy.ndarray[Any, Any]":
    """Whether a face covers the places at parameters (n, 2), its edges included, as an array (n,)."""
    points, _, inside = _core.evaluate_face(face, uv)
    inside = numpy.array(inside, dtype=bool)
    u_first, u_last, v_first, v_last = face.ParameterRange
    low, high = numpy.array((u_first, v_first)), numpy.array((u_last, v_last))
    slack = ON_EDGE_RELATIVE * (high - low)
    # Past the parameters' range the surface may run over the face once more.
    in_range = numpy.logical_and(uv >= low - slack, uv <= high + slack).all(axis=1)
    (open_rows,) = numpy.nonzero(~inside & in_range)
    if open_rows.size:
        distance = nearest_point(face, points[open_rows], trimmed=True).distance
        inside[open_rows] = distance <= ON_EDGE + ON_EDGE_RELATIVE * face.BoundBox.DiagonalLength
    return inside


def line_points(start: Any, end: Any, count: int) -> "numpy.ndarray[Any, Any]":
    """Points at equal steps from one to another, both included, as an array (count, 3)."""
    if count < 2:
        raise ValueError(f"n must be 2 or more, for the line's ends; it is {count}.")
    ends = _rows([tuple(start), tuple(end)], 3, "a and b")
    return ends[0] + numpy.linspace(0.0, 1.0, count)[:, None] * (ends[1] - ends[0])


def _levels(stack: "PlyStack", uv: Any, beside: Any) -> List[Tuple[Any, Any]]:
    """The levels of every ply, NaN where it is not and for the places beside the face. Plies of the whole face share the
    question where that is."""
    there: Dict[int, Any] = {}
    result = []
    for ply in stack.plies:
        key = id(ply.base_face)
        if key not in there:
            there[key] = covered(ply.base_face, uv) & ~beside
        bottom, top = (numpy.where(there[key], side, numpy.nan) for side in ply.heights(uv))
        result.append((bottom, top))
    return result


def _beside(face: Any, points: Any, uv: Any) -> "numpy.ndarray[Any, Any]":
    """Whether points lie past the end of the surface: their foot is on its end, and they are not on the normal there."""
    feet, normals, _ = _core.evaluate_face(face, uv)
    away = points - feet
    aside = numpy.linalg.norm(away - (away * normals).sum(axis=1)[:, None] * normals, axis=1)
    u_first, u_last, v_first, v_last = face.ParameterRange
    low, high = numpy.array((u_first, v_first)), numpy.array((u_last, v_last))
    at_end = (numpy.minimum(uv - low, high - uv) <= ON_EDGE_RELATIVE * (high - low)).any(axis=1)
    return at_end & (aside > ON_NORMAL * (1.0 + numpy.linalg.norm(away, axis=1)))


def _rows(values: Any, width: int, name: str) -> "numpy.ndarray[Any, Any]":
    rows = numpy.asarray(values, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != width:
        wanted = "u, v" if width == 2 else "x, y, z in mm"
        raise ValueError(f"{name} must be an array of shape (n, {width}): {wanted} in each row.")
    return rows
