# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences. The page's widgets write them; new objects start from them."""

from typing import Any, Dict

import FreeCAD as App

from ..ply_colours import BY_ANGLE, Colour

PATH = "User parameter:BaseApp/Preferences/Mod/LaminateOffset"
METHODS = ("same-parameter", "ravi-kumar")

#: Names of the colours' parameters by angles in degrees.
_COLOURS = {0.0: "Colour0", 45.0: "Colour45", 90.0: "Colour90", -45.0: "ColourMinus45"}


def _group() -> Any:
    return App.ParamGet(PATH)


def tolerance() -> float:
    """Of new objects [mm]."""
    value = _group().GetFloat("Tolerance", 1e-3)
    return value if value > 0 else 1e-3


def method() -> str:
    """Of new offsets."""
    index = _group().GetInt("Method", 0)
    return METHODS[index] if 0 <= index < len(METHODS) else METHODS[0]


def max_degree() -> int:
    """Of new objects, 3 to 7."""
    return min(max(_group().GetInt("MaxDegree", 7), 3), 7)


def thread_count() -> int:
    """Most processor cores that the engine uses; 0: all."""
    return max(_group().GetInt("Threads", 0), 0)


def drop_off_ratio() -> float:
    """Length of a ramp over its height, for new stacks."""
    return max(_group().GetFloat("DropOffRatio", 20.0), 0.0)


def angle_colours() -> Dict[float, Colour]:
    """Colours of plies by the angle of their fibres in degrees."""
    group = _group()
    return {angle: _unpacked(group.GetUnsigned(name, _packed(BY_ANGLE[angle]))) for angle, name in _COLOURS.items()}


def apply() -> None:
    """Lets the engine heed the preferences that are its own; called before it computes."""
    from .. import _core

    _core.limit_threads(thread_count())


def _packed(colour: Colour) -> int:
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8 | 255


def _unpacked(packed: int) -> Colour:
    return ((packed >> 24 & 255) / 255.0, (packed >> 16 & 255) / 255.0, (packed >> 8 & 255) / 255.0)
