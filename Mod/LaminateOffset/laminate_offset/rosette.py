# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rosettes: where the fibres of a ply run on a curved surface."""

from dataclasses import dataclass
from typing import Any, Iterable, Mapping, Optional, Sequence, Tuple, Union

import numpy
import Part

from . import _core
from .api import nearest_point
from .layup import PhysicalPly

# A projected axis shorter than this has no direction of its own: the rosette's axis stands on the surface.
SHORTEST = 1e-6


@dataclass(frozen=True)
class Rosette:
    """The axes that ply angles refer to.

    The rosette is set onto the surface at its origin: the first axis is `direction` projected onto the tangent plane at
    the point of the face nearest to `origin`, the third axis is the outward normal there. To every other point of the
    surface the first axis is moved without turning and then projected onto the tangent plane there (the plain transfer
    of composite tools). Where it would stand on the surface, the fibre direction does not exist. Angles count from the
    first axis, counter-clockwise as seen from the tip of the outward normal.

    Attributes:
        origin: x, y, z in mm.
        direction: x, y, z of the first axis; its length does not count.
    """

    origin: Tuple[float, float, float]
    direction: Tuple[float, float, float]

    def __post_init__(self) -> None:
        for name in ("origin", "direction"):
            object.__setattr__(self, name, _three_numbers(getattr(self, name), name))
        if not any(self.direction):
            raise ValueError("direction must not be zero; give the rosette's first axis.")


Rosettes = Union[Rosette, Mapping[str, Rosette]]


def check_rosette(rosette: Any) -> None:
    """Raises TypeError for what is neither a Rosette nor None."""
    if rosette is not None and not isinstance(rosette, Rosette):
        raise TypeError(f"rosette must be a Rosette; it is {rosette!r}.")


def check_one_rosette(plies: Iterable[PhysicalPly], remedy: str) -> None:
    """Raises ValueError where plies refer to different rosettes; the remedy ends the message."""
    names = list(dict.fromkeys(ply.ply.rosette for ply in plies))
    if len(names) > 1:
        listed = ", ".join(repr(name) if name else "none" for name in names)
        raise ValueError(
            f"The rows of the layup name different rosettes ({listed}), but one is used for all; {remedy}."
        )


def check_none_named(plies: Iterable[PhysicalPly], given: str) -> None:
    """Raises ValueError where rows name a rosette although none is given; `given` is how to give one."""
    named = next((ply.ply.rosette for ply in plies if ply.ply.rosette), None)
    if named is not None:
        raise ValueError(
            f"Rows of the layup name the rosette '{named}', which is not known; make a rosette of that name and give it {given}."
        )


def rosette_of(axes: Any, name: str, plies: Iterable[PhysicalPly], what: str = "axes") -> Rosette:
    """The rosette of a row that names it: of a mapping the one with that name, otherwise the only one of all plies. `what` is
    the argument that messages name."""
    if isinstance(axes, Rosette):
        check_one_rosette(plies, 'give all of them as {"name": Rosette}')
        return axes
    if not isinstance(axes, Mapping):
        raise TypeError(f'{what} must be a Rosette or a mapping {{"name": Rosette}}; it is {axes!r}.')
    found: Optional[Any] = axes.get(name)
    if found is None:
        raise ValueError(
            f"{what} has no rosette {name!r}, which the ply's row names; it has {', '.join(map(repr, axes))}."
        )
    if not isinstance(found, Rosette):
        raise TypeError(f"{what}[{name!r}] must be a Rosette; it is {found!r}.")
    return found


def fibre_directions(face: "Part.Face", uv: Any, rosette: Rosette, angle: float) -> "numpy.ndarray[Any, Any]":
    """The unit fibre directions at parameters of a face.

    Args:
        face: the lay-up surface; its outward normal counts.
        uv: array (n, 2) of parameters.
        rosette: the axes; see Rosette for the rule by which they are transferred.
        angle: of the fibres in degrees from the rosette's first axis.

    Returns:
        array (n, 3), tangent to the face and to all its offsets at the same parameters.

    Raises:
        ValueError: the rosette's axis stands on the surface at a point; says where.
        OffsetError: the face was refused, or it has no normal at a point.
    """
    points, normals, _ = _core.evaluate_face(face, numpy.asarray(uv, dtype=float))
    foot = nearest_point(face, [rosette.origin]).uv
    at_foot, normal_at_foot, _ = _core.evaluate_face(face, foot)
    axis = numpy.array(rosette.direction) / numpy.linalg.norm(rosette.direction)
    first = _projected(axis[None, :], normal_at_foot, at_foot)
    along = _projected(numpy.repeat(first, len(points), axis=0), normals, points)
    across = numpy.cross(normals, along)
    turn = numpy.radians(angle)
    return numpy.asarray(numpy.cos(turn) * along + numpy.sin(turn) * across)


def _three_numbers(given: Any, name: str) -> Tuple[float, ...]:
    try:
        values = numpy.array(tuple(given), dtype=float)
    except (TypeError, ValueError):
        values = numpy.array(())
    if values.shape != (3,) or isinstance(given, (str, bytes)) or not numpy.isfinite(values).all():
        raise ValueError(f"{name} must be three finite numbers x, y, z; it is {given!r}.")
    return tuple(float(value) for value in values)


def _projected(axes: Any, normals: Any, points: Any) -> Any:
    """The axes in the tangent planes, of length 1."""
    flat = axes - numpy.sum(axes * normals, axis=1)[:, None] * normals
    lengths = numpy.linalg.norm(flat, axis=1)
    lost = numpy.flatnonzero(lengths < SHORTEST)
    if lost.size:
        place = ", ".join(f"{value:.6g}" for value in _row(points, int(lost[0])))
        raise ValueError(
            f"The rosette's first axis stands on the surface at ({place}) mm, so it has no direction there; choose "
            "another axis."
        )
    return flat / lengths[:, None]


def _row(points: Any, index: int) -> Sequence[float]:
    return [float(value) for value in points[index]]
