# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the raw values of a file's rows or entries to plies and materials, with every problem collected on the way.

A value that is not allowed is kept as a problem, and a stand-in takes its place: so the other values, and what the
row has to do with other rows, are looked at in the same run.
"""

from dataclasses import replace
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Sequence, Tuple

from .errors import LayupError, Problem, quoted
from .fields import MATERIAL_FIELDS, PLY_FIELDS, Field
from .model import Material, Ply, layup_problems

Values = Dict[str, Any]


class Record(NamedTuple):
    """One row of a table or one entry of a document.

    Attributes:
        row: its number in messages.
        unit: what that number counts, see Problem.
        values: raw values by the names of fields; a field that is missing is not given.
        columns: what the file calls a field, where it is not the field's own column.
    """

    row: int
    unit: str
    values: Mapping[str, Any]
    columns: Mapping[str, str] = {}


def build_plies(records: Iterable[Record]) -> Tuple[List[Ply], List[Problem]]:
    """A ply for every record, and what is wrong with them."""
    plies: List[Ply] = []
    problems: List[Problem] = []
    for record in records:
        values, wrong = parse(PLY_FIELDS, record)
        columns = {problem.column for problem in wrong}
        values.setdefault("name", f"<{record.unit} {record.row}>")
        values.setdefault("material", "<not named>")
        if {_column(record, "material"), _column(record, "thickness")} & columns and values.get("thickness") is None:
            values["thickness"] = 1.0
        plies.append(Ply(**values))
        problems += wrong
    return plies, problems


def build_materials(records: Iterable[Record]) -> Tuple[List[Material], List[Problem]]:
    """A material for every record, and what is wrong with them."""
    materials: List[Material] = []
    problems: List[Problem] = []
    for record in records:
        values, wrong = parse(MATERIAL_FIELDS, record)
        values.setdefault("name", f"<{record.unit} {record.row}>")
        try:
            materials.append(Material(**values))
        except LayupError as error:
            wrong += located(error.problems, record)
            materials.append(Material(values["name"], values.get("cured_thickness")))
        problems += wrong
    return materials, problems


def together(
    plies: Sequence[Ply], materials: Sequence[Material], records: Mapping[str, Sequence[Record]]
) -> List[Problem]:
    """What is wrong with plies and materials together, at the places of their records, by "ply" and "material"."""
    problems: List[Problem] = []
    for problem in layup_problems(plies, materials):
        if problem.row is not None:
            problems += located([problem], records[problem.unit][problem.row - 1])
        else:
            problems.append(problem)
    return problems


def parse(rules: Iterable[Field], record: Record) -> Tuple[Values, List[Problem]]:
    """The values of a record that are allowed, and a problem for every other one."""
    values: Values = {}
    problems = []
    for rule in rules:
        raw = record.values.get(rule.name)
        try:
            values[rule.name] = rule.parse(raw)
        except (TypeError, ValueError, OverflowError):
            column = record.columns.get(rule.name, rule.column)
            problems.append(Problem(column, quoted(raw), rule.expected, record.row, record.unit))
    return values, problems


def located(problems: Iterable[Problem], record: Record) -> List[Problem]:
    """Problems of one thing at the place of its record, with the names of its columns."""
    return [
        replace(problem, column=_column(record, problem.column), row=record.row, unit=record.unit)
        for problem in problems
    ]


def _column(record: Record, field: str) -> str:
    rules = MATERIAL_FIELDS if record.unit == "material" else PLY_FIELDS
    usual = {rule.name: rule.column for rule in rules}
    return record.columns.get(field, usual.get(field, field))
