# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exceptions for layups and other tables that are not right, with every problem that was found."""

from dataclasses import dataclass
from typing import Optional, Sequence, Tuple


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a layup.

    Attributes:
        column: name of the column, or of the field, e.g. "angle_deg"; "" when the whole row or file is meant.
        found: what stands there, in quotation marks where it is text, e.g. "'4S'"; or what is wrong with it.
        expected: what is allowed there, e.g. "a number of degrees from -180 to 180".
        row: number from 1: of the table's row as a spreadsheet shows it (the header is row 1), of the ply or material
            in its list, or of the character in a text; None when the whole is meant.
        unit: what row counts: "row", "ply", "material", "line" or "character".
    """

    column: str
    found: str
    expected: str
    row: Optional[int] = None
    unit: str = "row"

    @property
    def place(self) -> str:
        """The place in words, e.g. "row 3, column angle_deg" or "ply 2, angle"."""
        column = f"column {self.column}" if self.column and self.unit == "row" else self.column
        return ", ".join(([] if self.row is None else [f"{self.unit} {self.row}"]) + ([column] if column else []))

    def __str__(self) -> str:
        place = self.place
        return f"{place + ': ' if place else ''}found {self.found}, expected {self.expected}"


class ProblemsError(ValueError):
    """Something with problems in it; the base of LayupError.

    The message names the source and, for every problem, the place, what was found and what is expected.

    Attributes:
        source: the file, or the text or object where there is none.
        problems: every Problem that was found, in the order of their places.
    """

    def __init__(self, source: str, problems: Sequence[Problem]) -> None:
        super().__init__(source, tuple(problems))
        self.source = source
        self.problems: Tuple[Problem, ...] = tuple(problems)

    def __str__(self) -> str:
        if len(self.problems) == 1:
            return f"{self.source}: {self.problems[0]}."
        lines = [f"{self.source}: {len(self.problems)} problems."]
        return "\n".join(lines + [f"  {problem}." for problem in self.problems])


class LayupError(ProblemsError):
    """A layup, or its file, that is not right.

    The message names the source and, for every problem, the place, what was found and what is expected.

    Attributes:
        source: the file, or the text or object where there is none.
        problems: every Problem that was found, in the order of their places.
    """


def quoted(value: object) -> str:
    """How a value that was found is shown in a message: text in quotation marks, nothing as "nothing"."""
    if value is None or value == "":
        return "nothing"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
