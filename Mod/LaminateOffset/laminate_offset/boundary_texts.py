# SPDX-License-Identifier: LGPL-2.1-or-later
"""What bounds plies, as the command line, tables of jobs and FreeCAD's objects write it: NAME=SIDE, NAME=D,D,... and
lengths of ramps."""

from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

import FreeCAD

from .boundaries import SIDES, Boundary, Stagger
from .files import read_named_shapes


def parse_side(text: str) -> Tuple[str, str]:
    """NAME=SIDE. Raises ValueError."""
    name, side = _named(text, "SIDE")
    if side not in SIDES:
        raise ValueError(f"'{text}' does not name one of {', '.join(SIDES)}")
    return name, side


def parse_stagger(text: str) -> Tuple[str, List[float]]:
    """NAME=D,D,... with distances in mm, or as FreeCAD lengths. Raises ValueError."""
    name, values = _named(text, "D,D,...")
    return name, _distances(values)


def stagger_of(entries: Sequence[str]) -> Optional[Stagger]:
    """What stack_plies takes, from one entry NAME=D,D,... for each boundary, or one entry D,D,... for all of them; None
    without entries. Raises ValueError.
    """
    texts = [entry.strip() for entry in entries if entry.strip()]
    if not texts:
        return None
    if len(texts) == 1 and "=" not in texts[0]:
        return _distances(texts[0])
    found: Dict[str, List[float]] = {}
    for text in texts:
        name, distances = parse_stagger(text)
        if name.strip() in found:
            raise ValueError(f"boundary {name.strip()!r} has two lists of distances; keep one")
        found[name.strip()] = distances
    return found


def parse_drop_off(text: str) -> Any:
    """A number, or a FreeCAD length. Raises ValueError."""
    value = _number_or_length(text)
    if value is None:
        raise ValueError(f"'{text}' is neither a number nor a length such as 5mm")
    return value


def boundaries_of(path: Optional[str], sides: Sequence[Tuple[str, str]], where: str) -> Dict[str, Boundary]:
    """The boundaries of a file by their names, with the sides that plies keep. Raises FileError for the file, and
    ValueError, which begins with `where`, for the side of a boundary that is not there."""
    shapes = read_named_shapes(path) if path else {}
    chosen = once(sides, where)
    for name in chosen:
        if name not in shapes:
            known = f"use one of {', '.join(shapes)}" if shapes else "give a file of boundaries"
            raise ValueError(f"{where}: there is no boundary {name!r}; {known}.")
    return {name: Boundary(shape, chosen.get(name, SIDES[0])) for name, shape in shapes.items()}


def once(entries: Iterable[Tuple[str, Any]], where: str) -> Dict[str, Any]:
    """The values by their boundaries. Raises ValueError, which begins with `where`, for a boundary that comes twice."""
    found: Dict[str, Any] = {}
    for name, value in entries:
        if name in found:
            raise ValueError(f"{where}: the boundary {name!r} is given twice; keep one.")
        found[name] = value
    return found


def _distances(text: str) -> List[float]:
    values = [_number_or_length(value) for value in text.split(",")]
    if any(value is None for value in values):
        raise ValueError(f"'{text}' is no list of distances in mm such as 0,8,16")
    return [float(getattr(value, "Value", value)) for value in values]


def _number_or_length(text: str) -> Any:
    """A number, a FreeCAD length, or None for what is neither."""
    try:
        return float(text)
    except ValueError:
        pass
    try:
        length = FreeCAD.Units.Quantity(text)
    except (OSError, ValueError, ArithmeticError):
        return None
    return length if length.Unit == FreeCAD.Units.Length else None


def _named(text: str, what: str) -> Tuple[str, str]:
    name, equals, value = text.rpartition("=")
    if not (name and equals and value):
        raise ValueError(f"'{text}' is not of the form NAME={what}")
    return name, value
