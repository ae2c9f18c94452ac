# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shorthand of laminates, e.g. [0/±45/90]2s: from text to plies and back.

    laminate = "[" plies "]" [ending]          ending: [count] ("s" symmetric | "T" total, the same as nothing)
    plies    = item { "/" item }
    item     = ply | "(" plies ")" [ending]    a group's ending works like a laminate's
    ply      = angle [tag] [ "_" count [tag] ] [ "~" ]
             | ("±" | "+-" | "∓" | "-+") angle [tag]                two plies, the upper sign first
    angle    = degrees, e.g. 45, -22.5, 30°
    tag      = letters that stand for a material, e.g. 0C or 0_2C in a hybrid laminate

"~" stands for the bar over the middle ply of a symmetric laminate: it may follow the last ply alone. Spaces and an
underscore before an ending are allowed, commas as well as slashes. "±45_2" is refused: it is read in two ways.
"""

import re
from dataclasses import dataclass
from decimal import Decimal
from typing import Iterable, List, Mapping, NoReturn, Optional, Sequence, Tuple

from .cards import known_materials
from .errors import LayupError, Problem, quoted
from .fields import MAX_COUNT
from .model import Layup, Material, Ply, checked_layup

MAX_DEPTH = 20
MAX_PLIES = 10000

_SIGNS = {"±": (1.0, -1.0), "+-": (1.0, -1.0), "∓": (-1.0, 1.0), "-+": (-1.0, 1.0)}
_PAIR = re.compile(r"±|∓|\+-|-\+")
_ANGLE = re.compile(r"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))\s*°?")
_TAG = re.compile(r"[A-Za-z]+")
_COUNT = re.compile(r"[0-9]+")
_ENDING = re.compile(r"\s*[0-9sStT]")
_ENDING_LETTER = re.compile(r"[sStT]")
_DIGITS = tuple("0123456789")


@dataclass(frozen=True)
class NotedPly:
    """One ply of a shorthand: its angle in degrees, how often it follows itself, and the tag of its material."""

    angle: float
    count: int = 1
    tag: str = ""


@dataclass(frozen=True)
class NotedLaminate:
    """A shorthand taken apart; the fields are those of a Layup."""

    plies: Tuple[NotedPly, ...]
    repeat: int = 1
    symmetric: bool = False
    middle_ply: bool = False


def layup_from_notation(
    text: str,
    material: str = "",
    thickness: Optional[float] = None,
    tags: Optional[Mapping[str, str]] = None,
    materials: Optional[Iterable[Material]] = None,
) -> Layup:
    """The layup that a shorthand such as "[0/45/-45/90]2s", "[(0/90)2/45~]s" or "[0_2C/±45G]s" stands for.

    The plies, named P1, P2 and so on, are listed from the tool outwards; "_2" lays a ply twice, "( )2" a group, a
    number after "]" all, "s" adds the mirror image, and "~" marks the middle ply, which is not mirrored. "±45" is
    45/-45, "∓45" or "-+45" is -45/45.

    Args:
        text: the shorthand.
        material: name of the material of plies without a tag.
        thickness: of every ply in mm; None: the cured thickness of its material.
        tags: names of materials by the letters after angles, e.g. {"C": "IM7-8552-134"}.
        materials: what materials may be beside those of the library; they come before it.

    Raises:
        LayupError: the text is no shorthand (the message names the character, from 1), a tag or a material is not
            known, or a ply has no thickness.
    """
    noted = parse_notation(text)
    names = _material_names(text, noted.plies, material, tags or {})
    plies = [
        Ply(f"P{index}", name, thickness, ply.angle, ply.count)
        for index, (ply, name) in enumerate(zip(noted.plies, names), start=1)
    ]
    known = known_materials(materials or ())
    return checked_layup(
        repr(text), plies, known, repeat=noted.repeat, symmetric=noted.symmetric, middle_ply=noted.middle_ply
    )


def _material_names(text: str, plies: Sequence[NotedPly], material: str, tags: Mapping[str, str]) -> List[str]:
    names = [tags.get(ply.tag, "") if ply.tag else material for ply in plies]
    known = f"a tag for a material: {', '.join(tags)}" if tags else "a tag for a material; there are none"
    problems = [
        Problem(
            "tag", quoted(ply.tag), known if ply.tag else known + ", or a material for plies without one", row, "ply"
        )
        for row, (ply, name) in enumerate(zip(plies, names), start=1)
        if not name
    ]
    if problems:
        raise LayupError(repr(text), problems)
    return names


def parse_notation(text: str) -> NotedLaminate:
    """Takes a shorthand apart. Raises LayupError, which names the character, from 1, and what is expected there."""
    return _Parser(text).laminate()


def print_notation(layup: Layup, tags: Optional[Mapping[str, str]] = None) -> str:
    """The shorthand of a layup's active plies; see Layup.notation."""
    active = [ply for ply in layup.plies if ply.active]
    if not active:
        raise LayupError("layup", [Problem("plies", "none that is active", "at least one", unit="layup")])
    letters = {material: tag for tag, material in (tags or {}).items()}
    noted = [NotedPly(ply.angle, ply.count, _tag_of(ply, letters) if tags else "") for ply in active]
    bar = "~" if layup.middle_ply and layup.plies[-1].active else ""
    ending = "s" if layup.symmetric else "T" if layup.repeat > 1 else ""
    repeat = "" if layup.repeat == 1 else str(layup.repeat)
    return f"[{'/'.join(_print_plies(noted, bool(bar)))}{bar}]{repeat}{ending}"


def _tag_of(ply: Ply, letters: Mapping[str, str]) -> str:
    try:
        return letters[ply.material]
    except KeyError:
        problem = Problem("material", quoted(ply.material), f"one with a tag: {', '.join(letters)}", unit="ply")
        raise LayupError(f"ply {quoted(ply.name)}", [problem]) from None


def _print_plies(plies: Sequence[NotedPly], barred: bool) -> List[str]:
    """The items between the slashes; a ply and its opposite become one with two signs, except below a bar."""
    items: List[str] = []
    index = 0
    while index < len(plies):
        ply = plies[index]
        opposite = NotedPly(-ply.angle, 1, ply.tag)
        last = index + 2 if not barred else index + 3
        if ply.count == 1 and ply.angle and last <= len(plies) and plies[index + 1] == opposite:
            items.append(("±" if ply.angle > 0.0 else "∓") + _degrees(abs(ply.angle)) + ply.tag)
            index += 2
        else:
            items.append(_degrees(ply.angle) + (f"_{ply.count}" if ply.count > 1 else "") + ply.tag)
            index += 1
    return items


def _degrees(angle: float) -> str:
    """An angle that is read back as the same number, without an exponent."""
    digits = format(Decimal(repr(angle)), "f")
    return digits.rstrip("0").rstrip(".") if "." in digits else digits


class _Parser:
    """Reads a shorthand from left to right; `position` counts characters from 0."""

    def __init__(self, text: str) -> None:
        self.text = text.replace("\N{MINUS SIGN}", "-")
        self.position = 0
        self.depth = 0
        self.bar: Optional[int] = None

    def laminate(self) -> NotedLaminate:
        self._demand("[", "'['")
        plies = self._plies()
        self._demand("]", "'/' or ']'")
        repeat, symmetric = self._ending()
        if self._peek():
            self._fail("the end, or an ending such as 2s")
        if self.bar is not None and not symmetric:
            self.position = self.bar
            self._fail("no '~', as the laminate does not end with s")
        return NotedLaminate(tuple(plies), repeat, symmetric, self.bar is not None)

    def _plies(self) -> List[NotedPly]:
        plies = self._item()
        while self._peek() in ("/", ","):
            if self.bar is not None:
                self._fail("']' after the middle ply")
            self.position += 1
            plies = self._limited(plies + self._item())
        return plies

    def _item(self) -> List[NotedPly]:
        if self._peek() == "(":
            return self._group()
        pair = self._match(_PAIR)
        return self._signed_pair(pair.group()) if pair else [self._ply()]

    def _group(self) -> List[NotedPly]:
        if self.depth == MAX_DEPTH:
            self._fail(f"at most {MAX_DEPTH} groups within each other")
        self.depth += 1
        self.position += 1
        plies = self._plies()
        if self.bar is not None:
            self.position = self.bar
            self._fail("no '~' within a group")
        self._demand(")", "'/' or ')'")
        self.depth -= 1
        repeat, symmetric = self._ending()
        plies = self._limited(plies * min(repeat, MAX_PLIES))
        return self._limited(plies + plies[::-1]) if symmetric else plies

    def _signed_pair(self, signs: str) -> List[NotedPly]:
        if self._peek() in ("+", "-"):
            self._fail("an angle without a sign")
        angle = self._angle()
        tag = self._tag()
        if self._peek() == "_":
            self._fail(
                f"no count, which is read in two ways: write ({signs}{_degrees(angle)})2 or the signs one by one"
            )
        if self._peek() == "~":
            self._fail("no '~' after two plies")
        return [NotedPly(sign * angle, 1, tag) for sign in _SIGNS[signs]]

    def _ply(self) -> NotedPly:
        angle = self._angle()
        tag = self._tag()
        count = 1
        if self._peek() == "_":
            self.position += 1
            count = self._count()
            tag = tag or self._tag()
        if self._peek() == "~":
            self.bar = self.position
            self.position += 1
        return NotedPly(angle, count, tag)

    def _angle(self) -> float:
        self._peek()
        start = self.position
        found = self._match(_ANGLE)
        if not found:
            self._fail("an angle in degrees")
        angle = float(found.group(1))
        if abs(angle) > 180.0:
            self.position = start
            self._fail("an angle from -180 to 180 degrees", found.group())
        return angle

    def _tag(self) -> str:
        found = self._match(_TAG)
        return found.group() if found else ""

    def _ending(self) -> Tuple[int, bool]:
        """(repeat, symmetric) after a closing bracket."""
        if self._peek() == "_":
            self.position += 1
            if not _ENDING.match(self.text, self.position):
                self._fail("a count or s or T after '_'")
        repeat = self._count() if self._peek() in _DIGITS else 1
        found = self._match(_ENDING_LETTER)
        return repeat, found is not None and found.group() in "sS"

    def _count(self) -> int:
        self._peek()
        start = self.position
        found = self._match(_COUNT)
        digits = found.group() if found else ""
        if not digits or len(digits) > 9 or not 1 <= int(digits) <= MAX_COUNT:
            self.position = start
            self._fail(f"a count from 1 to {MAX_COUNT}", digits or None)
        return int(digits)

    def _limited(self, plies: List[NotedPly]) -> List[NotedPly]:
        if len(plies) > MAX_PLIES:
            self._fail(f"groups that make at most {MAX_PLIES} plies")
        return plies

    def _peek(self) -> str:
        """The next character that is not a space; "" at the end."""
        while self.position < len(self.text) and self.text[self.position].isspace():
            self.position += 1
        return self.text[self.position : self.position + 1]

    def _match(self, pattern: "re.Pattern[str]") -> "Optional[re.Match[str]]":
        self._peek()
        found = pattern.match(self.text, self.position)
        if found:
            self.position = found.end()
        return found

    def _demand(self, character: str, expected: str) -> None:
        if self._peek() != character:
            self._fail(expected)
        self.position += 1

    def _fail(self, expected: str, found: Optional[str] = None) -> NoReturn:
        what = quoted(found if found is not None else self._peek()) if self._peek() else "the end"
        raise LayupError(repr(self.text), [Problem("", what, expected, self.position + 1, "character")])
