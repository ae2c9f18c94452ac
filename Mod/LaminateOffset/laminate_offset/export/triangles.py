# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces as triangles, for pictures and for solvers."""

from typing import Any, Callable, Tuple

import numpy

Array = Any  # a numpy array

# Corners of a triangle's sides: side i goes from corner i to the next one.
_SIDES = ((0, 1), (1, 2), (2, 0))


def triangles_of(face: Any, deviation: float, angle: float) -> Tuple[Array, Array]:
    """The points (n, 3) and the triangles (m, 3), rows of the points, of a face or shell, counter-clockwise as seen from its
    outer side.

    deviation: of sides from edges and of triangles from the surface, in mm. angle: between neighbours, in radians.
    """
    import MeshPart

    # A copy: meshing leaves triangles in a shape, which others may be working with.
    mesh = MeshPart.meshFromShape(
        Shape=face.copy(), LinearDeflection=deviation, AngularDeflection=angle, Relative=False
    )
    points, triangles = mesh.Topology
    corners = numpy.array([tuple(point) for point in points], dtype=float).reshape(-1, 3)
    chosen = numpy.array(triangles, dtype=int).reshape(-1, 3)
    return corners, chosen[numpy.linalg.norm(crossed(corners[chosen]), axis=1) > 0.0]


def crossed(corners: Array) -> Array:
    """The outward normals of triangles with corners (n, 3, 3), twice as long as the areas, as an array (n, 3)."""
    return numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def with_short_sides(
    points: Array, triangles: Array, longest: float, onto: Callable[[Array], Array]
) -> Tuple[Array, Array]:
    """The triangles with sides halved until none is longer than `longest` in mm; neighbours keep sharing their corners.

    onto: brings the middles of sides, an array (n, 3), onto the surface.
    """
    while True:
        ends = numpy.sort(triangles[:, _SIDES].reshape(-1, 2), axis=1)
        sides, index = numpy.unique(ends, axis=0, return_inverse=True)
        cut = numpy.linalg.norm(points[sides[:, 0]] - points[sides[:, 1]], axis=1) > longest
        if not cut.any():
            return points, triangles
        middle = numpy.full(len(sides), -1)
        middle[cut] = len(points) + numpy.arange(cut.sum())
        points = numpy.concatenate([points, onto(points[sides[cut]].mean(axis=1))])
        triangles = _split(triangles, middle[index].reshape(-1, 3))


def _split(triangles: Array, middles: Array) -> Array:
    """Triangles cut at the middles of their sides; -1 stands for a side that is not cut."""
    count = (middles >= 0).sum(axis=1)
    parts = [triangles[count == 0]]
    for number, mark in ((1, middles >= 0), (2, middles < 0)):
        chosen = count == number
        first = mark[chosen].argmax(axis=1)  # the side that differs from the two others
        turn = (first[:, None] + numpy.arange(3)) % 3
        (a, b, c), (ab, bc, ca) = (numpy.take_along_axis(rows[chosen], turn, axis=1).T for rows in (triangles, middles))
        corners = ((a, ab, c), (ab, b, c)) if number == 1 else ((a, b, bc), (a, bc, ca), (ca, bc, c))
        parts += [numpy.stack(corner, axis=-1) for corner in corners]
    (a, b, c), (ab, bc, ca) = triangles[count == 3].T, middles[count == 3].T
    parts += [numpy.stack(corner, axis=-1) for corner in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    return numpy.concatenate(parts)
