# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of plies, the same in the 3-D view and in pictures: by the angle of the fibres, or by the material."""

import colorsys
import zlib
from typing import Mapping, Optional, Tuple

#: Red, green, blue from 0 to 1.
Colour = Tuple[float, float, float]

#: The usual angles in degrees. Chosen to differ in lightness too, for those who see few hues.
BY_ANGLE: Mapping[float, Colour] = {
    0.0: (0.85, 0.22, 0.17),
    45.0: (0.95, 0.77, 0.20),
    90.0: (0.16, 0.42, 0.75),
    -45.0: (0.33, 0.66, 0.40),
}


def angle_colour(angle: float, chosen: Optional[Mapping[float, Colour]] = None) -> Colour:
    """The colour of plies with fibres at an angle in degrees; angles that differ by 180 are the same.

    Between the chosen angles, and those of BY_ANGLE, colours change evenly.

    Args:
        angle: in degrees.
        chosen: colours by angles in degrees that take the place of ours.
    """
    anchors = {key % 180.0: value for key, value in {**BY_ANGLE, **(chosen or {})}.items()}
    angle = angle % 180.0
    angles = sorted(anchors)
    below = max((each for each in angles if each <= angle), default=angles[-1] - 180.0)
    above = min((each for each in angles if each > angle), default=angles[0] + 180.0)
    share = (angle - below) / (above - below)
    low, high = anchors[below % 180.0], anchors[above % 180.0]
    return tuple((1.0 - share) * a + share * b for a, b in zip(low, high))  # type: ignore[return-value]


def material_colour(name: str) -> Colour:
    """A colour that a material of this name always has, in every document."""
    hue = zlib.crc32(name.encode("utf-8")) % 360 / 360.0
    return colorsys.hsv_to_rgb(hue, 0.55, 0.82)
