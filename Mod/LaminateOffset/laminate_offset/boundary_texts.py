# SPDX-License-Identifier: LGPL-2.1-or-later
"""What bounds plies, as the command line, tables of jobs and FreeCAD's objects write it: NAME=SIDE, NAME=D,D,... and
lengths of ramps."""

from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

import FreeCAD

from .boundaries import SIDES, Boundary, Stagger
from .files import read_named_shapes


def parse_side(text: str) -> Tuple[str, str]:
    """NAME=SIDE. Raises ValueError."""
    name, side = _named(text, "SIDE")
    if side.strip() not in SIDES:
        raise ValueError(f"'{text}' does not name one of {', '.join(SIDES)}")
    return name, side.strip()


def parse_stagger(text: str) -> Tuple[str, List[float]]:
    """NAME=D,D,... with distances in mm, or as FreeCAD lengths. Raises ValueError."""
    name, values = _named(text, "0,8,16")
    return name, _distances(values)


def stagger_of(entries: Sequence[str], where: str) -> Optional[Stagger]:
    """What stack_plies takes, from one entry NAME=D,D,... for each boundary, or one entry D,D,... for all of them; None
    without entries. Raises ValueError, which begins with `where`.
    """
    texts = [entry for entry in entries if entry.strip()]
    if len(texts) == 1 and "=" not in texts[0]:
        return _told(_distances, texts[0].strip(), where)
    return _named_entries(texts, parse_stagger, where) or None


def sides_of(entries: Sequence[str], where: str) -> Dict[str, str]:
    """The sides that plies keep by their boundaries, from one entry NAME=SIDE for each. Raises ValueError, which begins with
    `where`."""
    return _named_entries(entries, parse_side, where)


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
    return sided(shapes, once(sides, where), where, "give a file of boundaries")


def sided(shapes: Mapping[str, Any], sides: Mapping[str, str], where: str, remedy: str) -> Dict[str, Boundary]:
    """The boundaries of shapes, with the sides that plies keep. Raises ValueError, which begins with `where`, for the side of
    a boundary that is not there; it ends with the remedy where there is no boundary at all."""
    for name in sides:
        if name not in shapes:
            known = f"use one of {', '.join(shapes)}" if shapes else remedy
            raise ValueError(f"{where}: there is no boundary {name!r}; {known}.")
    return {name: Boundary(shape, sides.get(name, SIDES[0])) for name, shape in shapes.items()}


def once(entries: Iterable[Tuple[str, Any]], where: str) -> Dict[str, Any]:
    """The values by their boundaries. Raises ValueError, which begins with `where`, for a boundary that comes twice."""
    found: Dict[str, Any] = {}
    for name, value in entries:
        if name in found:
            raise ValueError(f"{where}: the boundary {name!r} is given twice; keep one.")
        found[name] = value
    return found


def _named_entries(texts: Sequence[str], parse: Callable[[str], Tuple[str, Any]], where: str) -> Dict[str, Any]:
    """The values of entries by their boundaries; blank entries, and blanks beside a name, do not count."""
    entries = [_told(parse, text.strip(), where) for text in texts if text.strip()]
    return once(((name.strip(), value) for name, value in entries), where)


def _told(parse: Callable[[str], Any], text: str, where: str) -> Any:
    try:
        return parse(text)
    except ValueError as error:
        raise ValueError(f"{where}: {error}.") from error


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
