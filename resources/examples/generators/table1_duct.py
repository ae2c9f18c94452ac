# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch of a bent duct with one opening, made like example 2 of Ravi Kumar, Shastry and Prakash (CAD 35, 2003, table 1).

2 loops, 6 trimming curves, a doubly curved free-form surface whose box has a diagonal of 2.27 m. The shape is our own:
the outside of a bend whose section grows along it. Its radii of curvature are above 0.6 m; offsets of a tenth of the
diagonal, 227 mm, are regular on both sides.

Usage: table1_duct.py [OUT.step]
"""

import math
import sys
from typing import Tuple

import trimmed_face as tf

NAME = "table1_duct"
BEND = 1661.5  # mm, radius of the duct's centre line
BORE = 640.0  # mm, radius of the section at u = 0; it grows by a quarter along u
TURN, GIRTH = math.radians(49.0), math.radians(130.0)  # of the bend along u, of the section around v
POLES = (9, 10)


def duct(u: float, v: float) -> Tuple[float, float, float]:
    """Point of the duct [mm]; u and v from 0 to 1 run along the bend and around the section."""
    turn, around = TURN * u, GIRTH * (v - 0.5)
    bore = BORE * (1.0 + 0.25 * u * u)
    out = BEND + bore * math.cos(around)
    return out * math.sin(turn), bore * math.sin(around), out * math.cos(turn) - BEND


def make() -> "tf.Part.Face":
    """The patch as a Part.Face."""
    surface = tf.spline_surface(duct, (0.0, 1.0), (0.0, 1.0), POLES)
    corners = [(0.05, 0.06), (0.94, 0.09), (0.90, 0.93), (0.10, 0.90)]
    outer = [
        tf.bezier(corners[0], (0.35, 0.02), (0.60, 0.14), corners[1]),
        tf.bezier(corners[1], (0.99, 0.50), corners[2]),
        tf.bezier(corners[2], (0.65, 0.99), (0.40, 0.84), corners[3]),
        tf.segment(corners[3], corners[0]),
    ]
    return tf.trimmed_face(surface, [outer, tf.ellipse_arcs((0.52, 0.48), (0.17, 0.20), 2)])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
