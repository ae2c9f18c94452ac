# SPDX-License-Identifier: LGPL-2.1-or-later
"""Core samples and thickness of a stack: which plies lie where, along the normals of the lay-up face."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, List, Tuple

import FreeCAD
import numpy

from . import _core
from .api import nearest_point

if TYPE_CHECKING:
    from .stack import PlyStack, StackPly


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
    levels = [ply.levels(uv) for ply in stack.plies]
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
    if rows.ndim == 2 and rows.shape[1] == 3:
        rows = nearest_point(stack.base_face, rows).uv
    uv = _rows(rows, 2, "places")
    total = numpy.zeros(len(uv))
    for ply in stack.plies:
        bottom, top = ply.levels(uv)
        total += numpy.nan_to_num(numpy.abs(top - bottom))
    return total


def line_points(start: Any, end: Any, count: int) -> "numpy.ndarray[Any, Any]":
    """Points at equal steps from one to another, both included, as an array (count, 3)."""
    if count < 2:
        raise ValueError(f"n must be 2 or more, for the line's ends; it is {count}.")
    ends = _rows([tuple(start), tuple(end)], 3, "a and b")
    return ends[0] + numpy.linspace(0.0, 1.0, count)[:, None] * (ends[1] - ends[0])


def _rows(values: Any, width: int, name: str) -> "numpy.ndarray[Any, Any]":
    rows = numpy.asarray(values, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != width:
        wanted = "u, v" if width == 2 else "x, y, z in mm"
        raise ValueError(f"{name} must be an array of shape (n, {width}): {wanted} in each row.")
    return rows
