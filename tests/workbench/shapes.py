# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes and measures that the workbench's tests share. Lengths are in mm."""

import math

import FreeCAD as App
import Part


def wavy_face():
    """A free-form face of 70 x 70 mm whose radii of curvature are above 15 mm."""
    surface = Part.BSplineSurface()
    points = [
        [App.Vector(10 * i, 10 * j, 5 * math.sin(0.7 * i) * math.cos(0.6 * j)) for j in range(8)] for i in range(8)
    ]
    surface.interpolate(points)
    return surface.toShape()


def largest_deviation(base, offset, distance, count=12):
    """Largest | |p - base| - |distance| | over points p of the offset face, by OCCT's own extrema."""
    u0, u1, v0, v1 = offset.ParameterRange
    worst, seen = 0.0, 0
    for i in range(count):
        for j in range(count):
            point = offset.valueAt(u0 + (u1 - u0) * (i + 0.5) / count, v0 + (v1 - v0) * (j + 0.5) / count)
            worst = max(worst, abs(base.distToShape(Part.Vertex(point))[0] - abs(distance)))
            seen += 1
    assert seen == count * count
    return worst


def side(base, offset):
    """+1 when the middle of the offset lies on the base's outward side, -1 on the other."""
    u0, u1, v0, v1 = offset.ParameterRange
    point = offset.valueAt((u0 + u1) / 2, (v0 + v1) / 2)
    u, v = base.Surface.parameter(point)
    return math.copysign(1.0, (point - base.valueAt(u, v)).dot(base.normalAt(u, v)))


def radius(feature):
    """Radius of a feature that is a single cylindrical or spherical face."""
    (face,) = feature.Shape.Faces
    return face.Surface.Radius
