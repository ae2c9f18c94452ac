# SPDX-License-Identifier: LGPL-2.1-or-later
"""Doubly curved lay-up panel with two openings: 3 loops, 9 trimming curves, 3.4 m across the diagonal.

It has the make-up of the first example in Ravi Kumar, Shastry and Prakash, "Computation of offset of trimmed NURBS
surfaces", CAD 35 (2003): a trimmed free-form surface with one outer and two inner loops. The shape is our own, a
panel of a fuselage-like barrel which narrows and flattens towards one end. Its radii of curvature are all above
1.5 m, so that offsets of a tenth of the diagonal are regular on both sides.

Usage: panel_two_holes.py [OUT.step]
"""

import math
import sys
from typing import Tuple

import trimmed_face as tf

NAME = "panel_two_holes"
LENGTH = 3260.0  # mm, along the barrel, u
GIRTH = 1800.0  # mm, around the barrel, v
RADIUS = 2000.0  # mm, of the barrel's cross-section at u = 0
POLES = (9, 7)


def barrel(u: float, v: float) -> Tuple[float, float, float]:
    """Point of the barrel [mm]; u [mm] runs along it, v [mm] around it from the crown."""
    along = u / LENGTH
    radius = RADIUS * (1.0 - 0.10 * along**2)
    angle = v / RADIUS
    sag = 260.0 * along**2 + 60.0 * along**3
    return u, radius * math.sin(angle), radius * math.cos(angle) - RADIUS - sag


def make() -> "tf.Part.Face":
    """The panel as a Part.Face."""
    half = 0.5 * GIRTH
    surface = tf.spline_surface(barrel, (0.0, LENGTH), (-half, half), POLES)
    corners = [(150.0, -740.0), (3120.0, -660.0), (3065.0, 720.0), (215.0, 680.0)]
    outer = [
        tf.bezier(corners[0], (1100.0, -840.0), (2250.0, -820.0), corners[1]),
        tf.bezier(corners[1], (3195.0, 0.0), corners[2]),
        tf.bezier(corners[2], (2190.0, 800.0), (1120.0, 820.0), corners[3]),
        tf.bezier(corners[3], (105.0, 0.0), corners[0]),
    ]
    tips = [(660.0, -340.0), (590.0, 310.0), (1350.0, 60.0)]
    triangle = [tf.segment(start, end) for start, end in zip(tips, tips[1:] + tips[:1])]
    oval = tf.ellipse_arcs((2200.0, -40.0), (400.0, 280.0), 2)
    return tf.trimmed_face(surface, [outer, triangle, oval])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
