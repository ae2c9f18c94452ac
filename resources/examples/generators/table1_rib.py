# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flat rib with two cut-outs, made like example 3 of Ravi Kumar, Shastry and Prakash (CAD 35, 2003, table 1).

3 loops, 24 trimming curves, a planar surface whose box has a diagonal of 1.04 m. The shape is our own: a rib with an
arched top, notches for stringers and two lightening holes. The plane is written as a bilinear spline, as in the paper,
where every surface is one, and stands aslant in space.

Usage: table1_rib.py [OUT.step]
"""

import sys
from typing import List, Sequence, Tuple

import trimmed_face as tf

NAME = "table1_rib"
LENGTH, HEIGHT = 1010.0, 420.0  # mm, of the plane's rectangle
ALONG, UP = (1.0, 0.0, 0.0), (0.0, 0.6, 0.8)  # unit vectors of the plane, at right angles


def plane(u: float, v: float) -> Tuple[float, float, float]:
    """Point of the plane [mm]; u and v are lengths [mm]."""
    return tuple(100.0 + u * a + v * b for a, b in zip(ALONG, UP))


def polygon(points: Sequence[Tuple[float, float]]) -> List["tf.Part.Geom2d.Curve2d"]:
    """Segments from each point to the next."""
    return [tf.segment(start, end) for start, end in zip(points, points[1:])]


def outline() -> List["tf.Part.Geom2d.Curve2d"]:
    """12 curves: the foot with a notch, the ends, the arched top with a notch."""
    foot = [(20.0, 30.0), (430.0, 30.0), (430.0, 70.0), (490.0, 70.0), (490.0, 30.0), (989.6, 30.0)]
    right, left = (960.0, 210.0), (20.0, 260.0)
    notch = [(560.0, 385.0), (560.0, 345.0), (500.0, 345.0), (500.0, 385.0)]
    return [
        *polygon(foot),
        tf.bezier(foot[-1], (1005.0, 130.0), right),
        tf.bezier(right, (880.0, 340.0), notch[0]),
        *polygon(notch),
        tf.bezier(notch[-1], (330.0, 420.0), (120.0, 360.0), left),
        tf.segment(left, foot[0]),
    ]


def rounded_hole(low: Tuple[float, float], high: Tuple[float, float], radius: float) -> List["tf.Part.Geom2d.Curve2d"]:
    """8 curves: a rectangle with rounded corners, each a parabola."""
    (x0, y0), (x1, y1) = low, high
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    steps = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]
    curves = []
    for k, (x, y) in enumerate(corners):
        ahead, before = steps[k], steps[k - 1]
        start = (x - radius * before[0], y - radius * before[1])
        end = (x + radius * ahead[0], y + radius * ahead[1])
        following = corners[(k + 1) % 4]
        stop = (following[0] - radius * ahead[0], following[1] - radius * ahead[1])
        curves += [tf.bezier(start, (x, y), end), tf.segment(end, stop)]
    return curves


def make() -> "tf.Part.Face":
    """The rib as a Part.Face."""
    surface = tf.spline_surface(plane, (0.0, LENGTH), (0.0, HEIGHT), (2, 2), (1, 1))
    oval = tf.ellipse_arcs((740.0, 190.0), (130.0, 95.0), 4)
    return tf.trimmed_face(surface, [outline(), rounded_hole((110.0, 100.0), (380.0, 280.0), 45.0), oval])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
