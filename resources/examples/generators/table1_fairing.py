# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fairing with two openings, made like example 1 of Ravi Kumar, Shastry and Prakash (CAD 35, 2003, table 1).

3 loops, 9 trimming curves, a doubly curved free-form surface whose box has a diagonal of 3.43 m. The shape is our own:
an arch across, a wave along, so that it has parts like a dome and parts like a saddle. Its radii of curvature inside
the loops are above 1.6 m; offsets of a tenth of the diagonal, 343 mm, are regular on both sides.

Usage: table1_fairing.py [OUT.step]
"""

import math
import sys
from typing import Tuple

import trimmed_face as tf

NAME = "table1_fairing"
LENGTH = 3175.0  # mm, along the wave, u
WIDTH = 1900.0  # mm, across, v from -WIDTH / 2
ARCH = 1700.0  # mm, radius of the arch across at u = 0; it opens by a fifth towards u = LENGTH
WAVE = 130.0  # mm, half height of the wave
POLES = (11, 8)


def fairing(u: float, v: float) -> Tuple[float, float, float]:
    """Point of the fairing [mm]."""
    along = u / LENGTH
    radius = ARCH * (1.0 + 0.2 * along)
    angle = v / radius
    height = WAVE * math.cos(1.5 * math.pi * along) - 140.0 * along
    return u, radius * math.sin(angle), radius * (math.cos(angle) - 1.0) + height


def make() -> "tf.Part.Face":
    """The fairing as a Part.Face."""
    half = 0.5 * WIDTH
    surface = tf.spline_surface(fairing, (0.0, LENGTH), (-half, half), POLES)
    corners = [(95.0, -790.0), (3036.0, -700.0), (3005.0, 810.0), (150.0, 705.0)]
    outer = [
        tf.bezier(corners[0], (1000.0, -920.0), (2100.0, -600.0), corners[1]),
        tf.bezier(corners[1], (3145.0, -150.0), (2950.0, 300.0), corners[2]),
        tf.bezier(corners[2], (2200.0, 930.0), (1000.0, 640.0), corners[3]),
        tf.bezier(corners[3], (60.0, 0.0), corners[0]),
    ]
    tips = [(2060.0, -330.0), (2660.0, -90.0), (2180.0, 380.0)]
    window = [
        tf.bezier(tips[0], (2420.0, -360.0), tips[1]),
        tf.bezier(tips[1], (2540.0, 260.0), tips[2]),
        tf.segment(tips[2], tips[0]),
    ]
    return tf.trimmed_face(surface, [outer, window, tf.ellipse_arcs((900.0, 20.0), (420.0, 300.0), 2)])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
