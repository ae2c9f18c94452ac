# SPDX-License-Identifier: LGPL-2.1-or-later
"""Half of a Wigley hull, the standard test hull of ship hydrodynamics, with a thruster opening: 2 loops, 6 edges.

y = B/2 (1 - (2x/L)^2) (1 - (z/T)^2) is a polynomial of degree 2 in x and in z, so that a single biquadratic patch of
9 poles is the hull itself. The face is trimmed at a waterline below the rest line, along a rising keel, and clear of
the sharp stem and stern posts; none of the outer edges follows the surface's parameter lines except the waterline.

Usage: wigley_hull.py [OUT.step]
"""

import sys
from typing import Tuple

import trimmed_face as tf

NAME = "wigley_hull"
LENGTH, BEAM, DRAUGHT = 6000.0, 600.0, 375.0  # mm; the usual proportions L/B = 10, B/T = 1.6
WATERLINE = -0.06 * DRAUGHT  # mm, where the face ends at the top


def hull(aft: float, z: float) -> Tuple[float, float, float]:
    """Point of the hull [mm] at the length aft of amidships and the height z (0 at the rest line).

    x points forward and y to the hull's side; counting aft makes the face's normal point out into the water.
    """
    return -aft, 0.5 * BEAM * (1.0 - (2.0 * aft / LENGTH) ** 2) * (1.0 - (z / DRAUGHT) ** 2), z


def make() -> "tf.Part.Face":
    """The half hull as a Part.Face."""
    end = 0.5 * LENGTH
    surface = tf.spline_surface(hull, (-end, end), (-DRAUGHT, 0.0), (3, 3), (2, 2))
    stern, bow = (0.94 * end, WATERLINE), (-0.96 * end, WATERLINE)
    heel, forefoot = (0.80 * end, -0.78 * DRAUGHT), (-0.72 * end, -0.88 * DRAUGHT)
    outer = [
        tf.segment(bow, stern),
        tf.bezier(stern, (0.92 * end, -0.55 * DRAUGHT), heel),
        tf.bezier(heel, (0.3 * end, -0.97 * DRAUGHT), (-0.4 * end, -0.97 * DRAUGHT), forefoot),
        tf.bezier(forefoot, (-0.93 * end, -0.75 * DRAUGHT), bow),
    ]
    opening = tf.ellipse_arcs((-0.62 * end, -0.52 * DRAUGHT), (85.0, 70.0), 2)
    return tf.trimmed_face(surface, [outer, opening])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
