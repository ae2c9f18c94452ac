# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the fibres of a ply run, for pictures and for the axes of a solver."""

from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy

from .. import _core
from ..api import nearest_point
from ..errors import OffsetError
from ..rosette import Rosette, check_none_named, check_one_rosette, check_rosette
from ..rosette import fibre_directions as directions_on

if TYPE_CHECKING:
    from ..stack import PlyStack

Array = Any  # a numpy array of floats

# What to do about plies of different rosettes, which pictures and sections cannot show.
THAT_ROSETTE = "as rosette=Rosette(origin, direction)"
ONE_ROSETTE = "write plies of one rosette only, with their angles counted from it"

# A model's x axis that stands on the surface more steeply than this (the cosine) does not serve as the first axis.
STEEP = 0.9
# Nor does one that comes so near to standing on it at one of so many places in each direction; these lie within 3 degrees
# of each other on a whole turn.
STANDING = 0.995
PLACES = 60


class Axes(NamedTuple):
    """The axes that ply angles refer to: unit vectors, first and second in the surface, third its outward normal."""

    first: Array
    second: Array
    normal: Array


def axes_of(stack: "PlyStack", rosette: Optional[Rosette] = None) -> Axes:
    """The axes of a rosette where it stands on the lay-up surface.

    Without a rosette, the first axis is the model's x axis projected onto the surface at the middle of its parameters, or
    another one where x stands on it; see usual_rosette. Raises ValueError where rows of the layup name different rosettes,
    or one although none is given, and TypeError for a rosette that is none.
    """
    check_rosette(rosette)
    plies = [ply.ply for ply in stack.plies]
    check_one_rosette(plies, ONE_ROSETTE)
    if rosette is None:
        check_none_named(plies, THAT_ROSETTE)
    face = stack.base_face
    chosen = usual_rosette(face) if rosette is None else rosette
    uv = nearest_point(face, [chosen.origin]).uv
    _, (normal,), _ = _core.evaluate_face(face, uv)
    (first,) = directions_on(face, uv, chosen, 0.0)
    return Axes(first, numpy.cross(normal, first), normal)


def usual_rosette(face: Any) -> Rosette:
    """On the middle of a face's parameters, along the model's x axis, or y where x stands too steeply on it there; where that
    one stands on the face elsewhere, along the first of x, y and z that does nowhere, if there is one."""
    u_first, u_last, v_first, v_last = face.ParameterRange
    uv = numpy.array([[0.5 * (u_first + u_last), 0.5 * (v_first + v_last)]])
    ((x, y, z),), (normal,), _ = _core.evaluate_face(face, uv)
    usual = 0 if abs(normal[0]) < STEEP else 1
    steepest = numpy.abs(_normals(face)).max(axis=0, initial=0.0)
    serving = [axis for axis in (usual, 0, 1, 2) if steepest[axis] < STANDING and abs(normal[axis]) < STEEP]
    first, second, third = numpy.eye(3)[serving[0] if serving else usual]
    return Rosette((x, y, z), (first, second, third))


def _normals(face: Any) -> Array:
    """Normals all over a face's parameters, (n, 3); none where the face has none at one of the places."""
    u_first, u_last, v_first, v_last = face.ParameterRange
    steps = (numpy.arange(PLACES) + 0.5) / PLACES
    u, v = numpy.meshgrid(u_first + (u_last - u_first) * steps, v_first + (v_last - v_first) * steps)
    try:
        return _core.evaluate_face(face, numpy.column_stack([u.ravel(), v.ravel()]))[1]
    except OffsetError:
        return numpy.zeros((0, 3))


def fibre_directions(axes: Axes, normals: Array, angle: float) -> Array:
    """The unit directions of the fibres at places with these outward normals, as arrays (n, 3).

    The first axis is moved to each place without turning it, projected onto the surface there, and turned by the angle
    in degrees about the normal, counter-clockwise as seen from its tip. Where the first axis stands on the surface
    there is no direction: zeros.
    """
    along = axes.first - (normals @ axes.first)[:, None] * normals
    lengths = numpy.linalg.norm(along, axis=1)
    along[lengths < 1e-6] = 0.0
    along /= numpy.where(lengths < 1e-6, 1.0, lengths)[:, None]
    turn = numpy.radians(angle)
    return numpy.cos(turn) * along + numpy.sin(turn) * numpy.cross(normals, along)
