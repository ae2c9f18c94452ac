# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layup tables: CSV with a header row, rows from the tool surface outwards.

Two kinds are recognised by their header: the plain one (ply, material, thickness_mm, angle_deg, then in any order and
each optional: count, boundary, active, rosette, group, sequence) and the one of 3DEXPERIENCE-style stack-up files
(Plies Group, Sequence, Ply, Material, Orientation, then grid limits). Columns are separated by commas, semicolons or
tabs, whichever the header has; a table with semicolons may have decimal commas.
"""

import csv
import io
from typing import Dict, List, Mapping, NamedTuple, Sequence, Tuple

from .errors import LayupError, Problem, quoted
from .fields import GRID_COLUMNS, LAYUP_FIELDS, PLY_FIELDS, SLENDER_COLUMNS, is_offset, limit_cell, limit_expected
from .model import Layup, Material, used_materials
from .records import Record, build_plies, together

# The columns of the kinds of tables and the fields that they hold.
PLAIN = {rule.column: rule.name for rule in PLY_FIELDS if rule.name != "limits"}
STACK_UP = {
    "Plies Group": "group",
    "Sequence": "sequence",
    "Ply": "name",
    "Material": "material",
    "Orientation": "angle",
}
TABLES = {"plain": PLAIN, "stack-up": STACK_UP}

# Needed when reading; written only where a ply has them.
PLAIN_REQUIRED = ("ply", "material", "thickness_mm", "angle_deg")
STACK_UP_REQUIRED = ("Sequence", "Ply", "Material", "Orientation")
OPTIONAL = ("group", "sequence", "Plies Group")

_NUMBERS = ("thickness", "angle", "count")


class Header(NamedTuple):
    """What the columns of a table mean.

    Attributes:
        fields: the field of every column, by the column's place; columns of grid limits have none.
        limits: the columns of grid limits, by their place.
        names: what the table calls a field.
    """

    fields: Mapping[int, str]
    limits: Mapping[int, str]
    names: Mapping[str, str]


def read_table(text: str, source: str, known: Mapping[str, Material]) -> Layup:
    """The layup of a table. Raises LayupError with every problem in it.

    Args:
        text: the file's content.
        source: what messages call it.
        known: the materials by their names; the layup gets those that its plies name.
    """
    delimiter = delimiter_of(text)
    rows = rows_of(text, source, delimiter)
    if not rows:
        raise LayupError(source, [Problem("", "nothing", f"a header row: {','.join(PLAIN_REQUIRED)},...", 1)])
    header = _header(rows[0][1], source)
    records: List[Record] = []
    problems: List[Problem] = []
    for row, cells in rows[1:]:
        record, wrong = _record(row, _texts(cells, header, delimiter), header)
        records.append(record)
        problems += wrong + _overfull(row, cells, header)
    plies, wrong = build_plies(records)
    problems += wrong
    problems += together(plies, tuple(known.values()), {"ply": records})
    if problems:
        raise LayupError(source, sorted(problems, key=lambda problem: problem.row or 0))
    return Layup(tuple(plies), used_materials(plies, known))


def print_table(layup: Layup, source: str, table: str, library: Mapping[str, Material]) -> str:
    """The plies as a table of one of the TABLES. Raises LayupError for everything that would be lost."""
    problems = _lost(layup, TABLES[table], library)
    if problems:
        raise LayupError(source, problems)
    columns = [
        column for column in TABLES[table] if column not in OPTIONAL or any(_given(layup, TABLES[table][column]))
    ]
    limits = _limit_columns(layup) if table == "stack-up" else ()
    stream = io.StringIO(newline="")
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([*columns, *limits])
    for ply in layup.plies:
        texts = dict(ply.limits)
        cells = [_cell(getattr(ply, TABLES[table][column])) for column in columns]
        writer.writerow(cells + [texts.get(column, "") for column in limits])
    return stream.getvalue()


def _lost(layup: Layup, columns: Mapping[str, str], library: Mapping[str, Material]) -> List[Problem]:
    """What a table with these columns has no place for."""
    expected = "nothing that this table has no place for; write a .json or .yaml file"
    problems = [
        Problem(rule.column, _cell(getattr(layup, rule.name)), expected, unit="layup")
        for rule in LAYUP_FIELDS
        if getattr(layup, rule.name) != rule.parse(None)
    ]
    own = [material.name for material in layup.materials if library.get(material.name) != material]
    problems += [Problem("materials", f"{quoted(name)} of one's own", expected, unit="layup") for name in own]
    held = {*columns.values(), *(("limits",) if columns is STACK_UP and _limit_columns(layup) else ())}
    for row, ply in enumerate(layup.plies, start=1):
        lost = [rule for rule in PLY_FIELDS if rule.name not in held and getattr(ply, rule.name) != rule.parse(None)]
        problems += [Problem(rule.column, quoted(getattr(ply, rule.name)), expected, row, "ply") for rule in lost]
    return problems


def _limit_columns(layup: Layup) -> Tuple[str, ...]:
    """The columns of the plies' grid limits in a stack-up file; none when they are of two kinds."""
    named = {column for ply in layup.plies for column, _ in ply.limits}
    return next((columns for columns in (GRID_COLUMNS, SLENDER_COLUMNS) if named <= set(columns)), ())


def delimiter_of(text: str) -> str:
    """The separator that the first line with anything in it has most of; a comma where it has none."""
    first = next((line for line in text.splitlines() if line.strip(" \t,;")), "")
    return max(",;\t", key=first.count)


def rows_of(text: str, source: str, delimiter: str) -> List[Tuple[int, List[str]]]:
    """(row number as a spreadsheet shows it, cells without space around) of every row that is not empty."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    rows = []
    number = 0
    try:
        for number, cells in enumerate(reader, start=1):
            if any(cell.strip() for cell in cells):
                rows.append((number, [cell.strip() for cell in cells]))
    except csv.Error as error:
        raise LayupError(source, [Problem("", str(error), "cells with closed quotation marks", number + 1)]) from error
    return rows


def _header(cells: Sequence[str], source: str) -> Header:
    """The meaning of the header row. Raises LayupError where a column is missing, unknown or there twice."""
    while cells and not cells[-1]:
        cells = cells[:-1]
    lower = [cell.lower() for cell in cells]
    stack_up = "orientation" in lower or "plies group" in lower
    fields, required = (STACK_UP, STACK_UP_REQUIRED) if stack_up else (PLAIN, PLAIN_REQUIRED)
    limits = SLENDER_COLUMNS if "limit 1" in lower else GRID_COLUMNS
    known = {column.lower(): column for column in (*fields, *(limits if stack_up else ()))}
    problems = [
        Problem(cell or f"number {place + 1}", _wrong_column(cell.lower() in known), f"one of {_join(known)}, once", 1)
        for place, cell in enumerate(cells)
        if cell.lower() not in known or cell.lower() in lower[:place]
    ]
    problems += [
        Problem(name, "no such column", "it in the header", 1) for name in required if name.lower() not in lower
    ]
    if problems:
        raise LayupError(source, problems)
    columns = [known[cell] for cell in lower]
    return Header(
        {place: fields[column] for place, column in enumerate(columns) if column in fields},
        {place: column for place, column in enumerate(columns) if column not in fields},
        {fields[column]: column for column in columns if column in fields},
    )


def _wrong_column(known: bool) -> str:
    return "the column a second time" if known else "a column that is not known"


def _texts(cells: Sequence[str], header: Header, delimiter: str) -> Dict[int, str]:
    """The cells below the header by their place; decimal commas become points where semicolons separate."""
    places = [*header.fields, *header.limits]
    texts = {place: cells[place] if place < len(cells) else "" for place in places}
    if delimiter == ";":
        numbers = [place for place, name in header.fields.items() if name in _NUMBERS]
        numbers += [place for place, column in header.limits.items() if is_offset(column)]
        texts.update({place: texts[place].replace(",", ".") for place in numbers})
    return texts


def _record(row: int, texts: Mapping[int, str], header: Header) -> Tuple[Record, List[Problem]]:
    """The values of a row, without offsets of grid limits that are none, and a problem for each of these."""
    values: Dict[str, object] = {name: texts[place] for place, name in header.fields.items()}
    limits, problems = {}, []
    for place, column in header.limits.items():
        try:
            limits[column] = limit_cell(column, texts[place])
        except ValueError:
            problems.append(Problem(column, quoted(texts[place]), limit_expected(column), row))
    return Record(row, "row", {**values, "limits": limits}, header.names), problems


def _overfull(row: int, cells: Sequence[str], header: Header) -> List[Problem]:
    width = len(header.fields) + len(header.limits)
    return [
        Problem("", f"{quoted(cell)} in cell {place}", f"{width} cells, as in the header", row)
        for place, cell in enumerate(cells, start=1)
        if place > width and cell
    ]


def _given(layup: Layup, name: str) -> List[bool]:
    return [bool(getattr(ply, name)) for ply in layup.plies]


def _cell(value: object) -> str:
    """The shortest text that is read back as the same value."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "1" if value else "0"
    if isinstance(value, float):
        return repr(value)[:-2] if repr(value).endswith(".0") else repr(value)
    return str(value)


def _join(columns: Mapping[str, str]) -> str:
    return ", ".join(columns.values())
