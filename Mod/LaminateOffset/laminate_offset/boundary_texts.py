# SPDX-License-Identifier: LGPL-2.1-or-later
"""What bounds plies, as the command line and tables of jobs write it: NAME=SIDE, NAME=D,D,... and lengths of ramps."""

from typing import Any, Dict, List, Optional, Sequence, Tuple

import FreeCAD

from .boundaries import SIDES, Boundary
from .files import read_named_shapes


def parse_side(text: str) -> Tuple[str, str]:
    """NAME=SIDE. Raises ValueError."""
    name, side = _named(text, "SIDE")
    if side not in SIDES:
        raise ValueError(f"'{text}' does not name one of {', '.join(SIDES)}")
    return name, side


def parse_stagger(text: str) -> Tuple[str, List[float]]:
    """NAME=D,D,... with distances in mm. Raises ValueError."""
    name, values = _named(text, "D,D,...")
    try:
        return name, [float(value) for value in values.split(",")]
    except ValueError:
        raise ValueError(f"'{values}' is no list of distances in mm") from None


def parse_drop_off(text: str) -> Any:
    """A number, or a FreeCAD length. Raises ValueError."""
    try:
        return float(text)
    except ValueError:
        pass
    try:
        length = FreeCAD.Units.Quantity(text)
    except (OSError, ValueError, ArithmeticError):
        length = None
    if length is None or length.Unit != FreeCAD.Units.Length:
        raise ValueError(f"'{text}' is neither a number nor a length such as 5mm")
    return length


def boundaries_of(path: Optional[str], sides: Sequence[Tuple[str, str]], where: str) -> Dict[str, Boundary]:
    """The boundaries of a file by their names, with the sides that plies keep. Raises FileError for the file, and
    ValueError, which begins with `where`, for the side of a boundary that is not there."""
    shapes = read_named_shapes(path) if path else {}
    chosen = dict(sides)
    for name in chosen:
        if name not in shapes:
            known = f"use one of {', '.join(shapes)}" if shapes else "give a file of boundaries"
            raise ValueError(f"{where}: there is no boundary {name!r}; {known}.")
    return {name: Boundary(shape, chosen.get(name, SIDES[0])) for name, shape in shapes.items()}


def _named(text: str, what: str) -> Tuple[str, str]:
    name, equals, value = text.rpartition("=")
    if not (name and equals and value):
        raise ValueError(f"'{text}' is not of the form NAME={what}")
    return name, value
