# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fields of materials, plies and layups may hold: one rule each, for tables, documents and Python alike."""

import math
import re
from numbers import Integral, Real
from typing import Any, Callable, NamedTuple, Optional, Tuple

MAX_COUNT = 1000
MAX_LENGTH = 1e6
MAX_DENSITY = 1e5

GRID_COLUMNS = ("Starting Plane", "End Plane", "LEFT LIMIT", "Offset", "RIGHT LIMIT", "Offset 2")
SLENDER_COLUMNS = tuple(f"{kind} {number}" for number in range(1, 5) for kind in ("Limit", "Offset"))

# Python itself would also read "1_000", "infinity" and the digits of other scripts.
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
_WHOLE = re.compile(r"\+?[0-9]{1,9}")

_TRUE = ("1", "true", "yes")
_FALSE = ("0", "false", "no")


class Field(NamedTuple):
    """One field of a class and of the files that hold it.

    Attributes:
        name: the attribute of the class.
        column: the name in tables and documents.
        parse: turns a cell's text, a document's value or a Python value into the attribute's value; raises ValueError
            for what is not allowed. Blank text stands for a value that is not given.
        expected: what is allowed, in words.
    """

    name: str
    column: str
    parse: Callable[[Any], Any]
    expected: str


def number(low: float, high: float, above: bool = False, optional: bool = False) -> Callable[[Any], Optional[float]]:
    """A parser of finite numbers from low to high; above: low itself is left out; optional: blank gives None."""

    def parse(value: Any) -> Optional[float]:
        if optional and _is_blank(value):
            return None
        result = float(_plain(value, Real, _NUMBER))
        if not math.isfinite(result) or not low <= result <= high or (above and result == low):
            raise ValueError
        return result

    return parse


def count(value: Any) -> int:
    """A whole number from 1 to MAX_COUNT; blank gives 1."""
    if _is_blank(value):
        return 1
    result = int(_plain(value, Integral, _WHOLE))
    if not 1 <= result <= MAX_COUNT:
        raise ValueError
    return result


def flag(default: bool) -> Callable[[Any], bool]:
    """A parser of yes and no; blank gives the default."""

    def parse(value: Any) -> bool:
        word = "1" if value is True else "0" if value is False else str(value).strip().lower()
        if _is_blank(value):
            return default
        if word in _TRUE or word in _FALSE:
            return word in _TRUE
        raise ValueError

    return parse


def text(value: Any) -> str:
    """Printable text without space around it; blank gives ""."""
    if value is None:
        return ""
    if not isinstance(value, str) or not value.strip().isprintable():
        raise ValueError
    return value.strip()


def name(value: Any) -> str:
    """Text as above that is not empty."""
    result = text(value)
    if not result:
        raise ValueError
    return result


def choice(*words: str) -> Callable[[Any], str]:
    """A parser of one of these words, in any case; blank gives the first."""

    def parse(value: Any) -> str:
        if _is_blank(value):
            return words[0]
        if not isinstance(value, str) or value.strip().lower() not in words:
            raise ValueError
        return value.strip().lower()

    return parse


def limits(value: Any) -> Tuple[Tuple[str, str], ...]:
    """The grid limits of a ply as pairs of a column of a stack-up file and its text; blank ones are dropped."""
    if _is_blank(value):
        return ()
    pairs = dict(value)
    known = [columns for columns in (GRID_COLUMNS, SLENDER_COLUMNS) if set(pairs) <= set(columns)]
    if not known:
        raise ValueError
    cleaned = [(column, limit_cell(column, pairs[column])) for column in known[0] if column in pairs]
    return tuple((column, cell) for column, cell in cleaned if cell)


def limit_cell(column: str, value: Any) -> str:
    """The text of one cell of the grid limits; an offset must be a number in mm."""
    cell = text(value)
    if cell and is_offset(column):
        number(-MAX_LENGTH, MAX_LENGTH)(cell)
    return cell


def is_offset(column: str) -> bool:
    """Whether a column of grid limits holds a length."""
    return column.startswith("Offset")


def limit_expected(column: str) -> str:
    """What is allowed in a column of grid limits, in words."""
    return "a number of mm, or nothing" if is_offset(column) else _TEXT


def _plain(value: Any, kind: type, pattern: "re.Pattern[str]") -> Any:
    """The value, if it is of that kind or text that the pattern covers; else ValueError."""
    if isinstance(value, bool) or not isinstance(value, (str, kind)):
        raise ValueError
    if isinstance(value, str) and not pattern.fullmatch(value.strip()):
        raise ValueError
    return value


def _is_blank(value: Any) -> bool:
    return value is None or (isinstance(value, str) and not value.strip()) or (isinstance(value, tuple) and not value)


_LENGTH = f"a number of mm above 0, at most {MAX_LENGTH:g}, or nothing"
_COUNT = f"a whole number from 1 to {MAX_COUNT}"
_FLAG = "yes or no (or 1 or 0, true or false)"
_TEXT = "printable text"

MATERIAL_FIELDS = (
    Field("name", "material", name, "a material's name"),
    Field("cured_thickness", "cured_thickness_mm", number(0.0, MAX_LENGTH, above=True, optional=True), _LENGTH),
    Field(
        "areal_weight",
        "areal_weight_g_m2",
        number(0.0, MAX_LENGTH, above=True, optional=True),
        f"a number of g/m2 above 0, at most {MAX_LENGTH:g}, or nothing",
    ),
    Field(
        "density",
        "density_kg_m3",
        number(0.0, MAX_DENSITY, above=True, optional=True),
        f"a number of kg/m3 above 0, at most {MAX_DENSITY:g}, or nothing",
    ),
    Field("roll_width", "roll_width_mm", number(0.0, MAX_LENGTH, above=True, optional=True), _LENGTH),
    Field("description", "description", text, _TEXT),
    Field("source", "source", text, _TEXT),
)

PLY_FIELDS = (
    Field("name", "ply", name, "a ply's name"),
    Field("material", "material", name, "a material's name"),
    Field("thickness", "thickness_mm", number(0.0, MAX_LENGTH, above=True, optional=True), _LENGTH),
    Field("angle", "angle_deg", number(-180.0, 180.0), "a number of degrees from -180 to 180"),
    Field("count", "count", count, _COUNT),
    Field("boundary", "boundary", text, "the name of a closed curve or sketch, or nothing for the whole face"),
    Field("active", "active", flag(True), _FLAG),
    Field("rosette", "rosette", text, "the name of a rosette, or nothing"),
    Field("group", "group", text, "the name of a plies group, or nothing"),
    Field("sequence", "sequence", text, "the name of a sequence, or nothing"),
    Field("limits", "limits", limits, f"texts for some of {', '.join(GRID_COLUMNS)}, offsets as numbers of mm"),
)

LAYUP_FIELDS = (
    Field("repeat", "repeat", count, _COUNT),
    Field("symmetric", "symmetric", flag(False), _FLAG),
    Field("middle_ply", "middle_ply", flag(False), _FLAG),
    Field("direction", "direction", choice("normal", "reversed"), "normal or reversed"),
    Field("reference", "reference", choice("tool", "middle", "top"), "tool, middle or top"),
)
