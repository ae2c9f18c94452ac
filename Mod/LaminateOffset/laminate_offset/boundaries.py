# SPDX-License-Identifier: LGPL-2.1-or-later
"""What bounds plies: curves by name, the side that is kept, and how far successive plies keep inside of them."""

import math
from dataclasses import dataclass
from numbers import Real
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import FreeCAD
import numpy
import Part

from .api import Length, millimetres
from .layup import Layup, LayupError, PhysicalPly
from .layup.errors import Problem

SIDES = ("inside", "outside", "left", "right")
# Stands for the ratio where a ramp's length is given.
DEFAULT_RATIO = 20.0


@dataclass(frozen=True)
class Boundary:
    """A boundary of plies.

    Attributes:
        shape: a Part.Wire, a Part.Edge, a list of edges, a Part.Face (its wires), a compound of these, or a document
            object with such a Shape, a sketch for instance. It lies on the lay-up face or near it.
        side: the part of the face that plies keep: "inside" or "outside" of closed curves, where a closed curve inside
            another one is a hole; or what lies "left" or "right" of the curve's direction for someone who stands on the face
            with the outward normal upwards.
        point: keeps the part next to this point (x, y, z in mm) instead, whatever the side is.
    """

    shape: Any
    side: str = "inside"
    point: Optional[Sequence[float]] = None

    def __post_init__(self) -> None:
        if self.side not in SIDES:
            raise ValueError(f"side must be one of {', '.join(SIDES)}; it is {self.side!r}.")
        if self.point is not None:
            object.__setattr__(self, "point", _checked_point(self.point))

    def for_engine(self, name: str) -> Tuple[str, "Part.Shape", str, Tuple[float, float, float]]:
        """Name, shape, side and point as the compiled part takes them."""
        x, y, z = self.point if self.point is not None else (0.0, 0.0, 0.0)
        side = self.side if self.point is None else "nearest"
        return name, _shape(self.shape, name), side, (float(x), float(y), float(z))


Boundaries = Mapping[str, Any]
Stagger = Union[Sequence[Length], Mapping[str, Sequence[Length]]]


def named_boundaries(boundaries: Optional[Boundaries]) -> Dict[str, Boundary]:
    """All of them as Boundary objects. Raises TypeError for anything but a mapping."""
    if boundaries is None:
        return {}
    if not isinstance(boundaries, Mapping):
        raise TypeError(f'boundaries must be a mapping {{"name": shape or Boundary}}; it is {boundaries!r}.')
    return {name: value if isinstance(value, Boundary) else Boundary(value) for name, value in boundaries.items()}


def check_names(layup: Layup, known: Sequence[str]) -> None:
    """Raises LayupError for every active row whose boundary is not known."""
    expected = f"one of {', '.join(known)}, or nothing" if known else "nothing: no boundaries were given"
    problems = [
        Problem("boundary", repr(ply.boundary), expected, row, "ply")
        for row, ply in enumerate(layup.plies, start=1)
        if ply.active and ply.boundary and ply.boundary not in known
    ]
    if problems:
        raise LayupError("layup", problems)


def insets(plies: Sequence[PhysicalPly], stagger: Optional[Stagger]) -> List[float]:
    """How far every ply keeps inside of its boundary in mm: of one boundary's plies, the first takes the first distance.

    Raises ValueError for a table that does not fit the plies, TypeError for one that is none.
    """
    if stagger is None:
        return [0.0] * len(plies)
    names = list(dict.fromkeys(ply.ply.boundary for ply in plies if ply.ply.boundary))
    if isinstance(stagger, Mapping):
        tables = {name: _distances(values) for name, values in stagger.items()}
    else:
        tables = dict.fromkeys(names, _distances(stagger))
    for name in tables:
        if name not in names:
            remedy = f"use one of {', '.join(names)}" if names else "name it in the layup"
            raise ValueError(f"stagger names the boundary {name!r}, which no ply has; {remedy}.")
    _check_counts(plies, tables, isinstance(stagger, Mapping))
    result = []
    used: Dict[str, int] = {}
    for ply in plies:
        name = ply.ply.boundary
        if name not in tables:
            result.append(0.0)
            continue
        place = used.get(name, 0)
        used[name] = place + 1
        result.append(tables[name][place])
    return result


def _check_counts(plies: Sequence[PhysicalPly], tables: Mapping[str, List[float]], own: bool) -> None:
    """Raises ValueError where a boundary's table has fewer distances than the boundary has plies, or more: a table of all
    boundaries, more than any of them has."""
    counts = {name: sum(1 for ply in plies if ply.ply.boundary == name) for name in tables}
    for name, distances in tables.items():
        most = counts[name] if own else max(counts.values())
        if not counts[name] <= len(distances) <= most:
            raise ValueError(
                f"stagger has {len(distances)} distances for boundary {name!r}, which has {counts[name]} plies; give one "
                "for each, with a point for decimals."
            )


def drop_off_of(drop_off: Length) -> Tuple[float, Optional[float]]:
    """The ramp's ratio, and its length in mm where a length was given. Raises ValueError and TypeError for what is
    neither."""
    wanted = "a multiple of the ply's thickness above 0, or a FreeCAD length above 0"
    if isinstance(drop_off, FreeCAD.Units.Quantity):
        if drop_off.Unit != FreeCAD.Units.Length and drop_off.Unit != FreeCAD.Units.Unit():
            raise ValueError(f"drop_off must be {wanted}; {drop_off.UserString} is none.")
        value, is_length = float(drop_off.Value), drop_off.Unit == FreeCAD.Units.Length
    elif isinstance(drop_off, Real) and not isinstance(drop_off, (bool, numpy.bool_)):
        value, is_length = float(drop_off), False
    else:
        raise TypeError(f"drop_off must be {wanted}; it is {drop_off!r}.")
    if not (math.isfinite(value) and value > 0.0):
        raise ValueError(f"drop_off must be {wanted}; it is {value:g}.")
    return (DEFAULT_RATIO, value) if is_length else (value, None)


def gap_of(boundary_gap: Length) -> float:
    """The largest distance of boundaries from the face in mm. Raises ValueError and TypeError for what is none."""
    wanted = "a distance in mm or a FreeCAD length, zero or more"
    if not isinstance(boundary_gap, (Real, FreeCAD.Units.Quantity)) or isinstance(boundary_gap, (bool, numpy.bool_)):
        raise TypeError(f"boundary_gap must be {wanted}; it is {boundary_gap!r}.")
    gap = millimetres(boundary_gap, "boundary_gap")
    if not (math.isfinite(gap) and gap >= 0.0):
        raise ValueError(f"boundary_gap must be {wanted}; it is {gap:g}.")
    return gap


def _distances(values: Any) -> List[float]:
    """One table of a stagger, in mm."""
    wanted = "a list of distances in mm or FreeCAD lengths, zero or more"
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise TypeError(f"stagger must be {wanted}, or such lists by the names of boundaries; it is {values!r}.")
    distances = []
    for value in values:
        if not isinstance(value, (Real, FreeCAD.Units.Quantity)) or isinstance(value, (bool, numpy.bool_)):
            raise TypeError(f"stagger must be {wanted}; {value!r} is none.")
        distance = millimetres(value, "stagger")
        if not (math.isfinite(distance) and distance >= 0.0):
            raise ValueError(f"stagger must be {wanted}; {distance:g} is none.")
        distances.append(distance)
    return distances


def _checked_point(point: Any) -> Tuple[float, float, float]:
    try:
        values = numpy.array(tuple(point), dtype=float)
    except (TypeError, ValueError):
        values = numpy.array(())
    if values.shape != (3,) or isinstance(point, (str, bytes)) or not numpy.isfinite(values).all():
        raise ValueError(f"point must be three finite numbers x, y and z in mm; it is {point!r}.")
    x, y, z = (float(value) for value in values)
    return x, y, z


def _shape(given: Any, name: str) -> "Part.Shape":
    shape = getattr(given, "Shape", given)
    if isinstance(shape, (list, tuple)):
        shape = Part.Compound(list(shape))
    if not isinstance(shape, Part.Shape) or shape.isNull():
        raise TypeError(f"Boundary {name!r} must be a Part shape, a list of edges or an object with a Shape.")
    return shape
