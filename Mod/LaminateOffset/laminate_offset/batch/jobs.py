# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of jobs: CSV with a header row and one row a job."""

import os
from dataclasses import asdict, dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

from ..boundaries import SIDES, drop_off_of
from ..boundary_texts import parse_drop_off, parse_side, parse_stagger
from ..files import FORMATS
from ..layup.errors import LayupError, Problem, ProblemsError, quoted
from ..layup.fields import MAX_LENGTH, number, text
from ..layup.tables import delimiter_of, rows_of
from ..layup.text_files import read_text
from ..stack import RAMP_SLOPES

BOUNDING = ("boundaries", "side", "drop_off", "ramp_slope", "stagger", "boundary_gap")
COLUMNS = ("input", "face", "distance", "layup", "tolerance", "output", *BOUNDING)
REQUIRED = ("input", "face", "output")
# Other names that a column may have in the header.
ALIASES = {"distance_mm": "distance", "tolerance_mm": "tolerance", "boundary_gap_mm": "boundary_gap"}
NUMBERS = ("distance", "tolerance", "drop_off", "boundary_gap")
# Between the entries of one cell.
BETWEEN = "|"

RECORD_ENDING = ".json"
SUMMARY = "summary.csv"


class JobsError(ProblemsError):
    """A table of jobs that is not right, with every problem that was found; see LayupError."""


@dataclass(frozen=True)
class Job:
    """One row of the table.

    Attributes:
        row: its number as a spreadsheet shows it; the header is row 1.
        input: the CAD file, as it stands in the table: relative paths start at the table's folder, or at the current
            one where there is no such file.
        face: the face's number from 1; None: all faces, each by itself.
        distance: signed distance in mm; None for a stack.
        layup: the file of the layup, found as the input is; "" for an offset.
        tolerance: in mm; None: the default.
        output: the result's file, within the folder of results.
        boundaries: the file of what bounds the layup's plies, found as the input is; "" where there is none.
        side, stagger: entries "NAME=SIDE" and "NAME=D,D,...".
        drop_off: a multiple of a ply's thickness or a length, as text; "" for the default.
        ramp_slope: "mean", "steepest" or "" for the default.
        boundary_gap: in mm; None: the default.
    """

    row: int
    input: str
    face: Optional[int]
    distance: Optional[float]
    layup: str
    tolerance: Optional[float]
    output: str
    boundaries: str = ""
    side: Tuple[str, ...] = ()
    drop_off: str = ""
    ramp_slope: str = ""
    stagger: Tuple[str, ...] = ()
    boundary_gap: Optional[float] = None

    def task(self) -> Dict[str, Any]:
        """What is to be done, as JSON has it, without the row's number, since a job that moves in the table is still the
        same, and without the columns on boundaries that say nothing."""
        values = asdict(self)
        del values["row"]
        told = {name: list(value) if isinstance(value, tuple) else value for name, value in values.items()}
        return {name: value for name, value in told.items() if name not in BOUNDING or value not in ("", [], None)}


def read_jobs(path: str) -> List[Job]:
    """The jobs of a table. Raises JobsError, which names row and column of every problem."""
    try:
        content = read_text(path)
        delimiter = delimiter_of(content)
        rows = rows_of(content, path, delimiter)
    except LayupError as error:
        raise JobsError(error.source, error.problems) from error
    if not rows:
        raise JobsError(path, [Problem("", "nothing", f"a header row with {', '.join(COLUMNS)}", 1)])
    places = _header(rows[0][1], path)
    jobs: List[Job] = []
    problems: List[Problem] = []
    for row, cells in rows[1:]:
        texts = {name: cells[place] if place < len(cells) else "" for name, place in places.items()}
        if delimiter == ";":
            texts.update({name: texts.get(name, "").replace(",", ".") for name in NUMBERS})
        job, wrong = _job(row, texts)
        jobs.append(job)
        problems += wrong + _overfull(row, cells, len(rows[0][1]))
    problems += _repeated_outputs(jobs)
    if not jobs:
        problems.append(Problem("", "no rows", "one row for every job", unit="table"))
    if problems:
        raise JobsError(path, sorted(problems, key=lambda problem: problem.row or 0))
    return jobs


def resolve(path: str, table_folder: str) -> str:
    """Where a file of the table is: at the table, or else in the current folder."""
    beside = os.path.join(table_folder, path)
    return os.path.abspath(path if not os.path.exists(beside) and os.path.exists(path) else beside)


def _header(cells: Sequence[str], source: str) -> Dict[str, int]:
    """The place of every column."""
    places: Dict[str, int] = {}
    problems = []
    for place, cell in enumerate(cells):
        name = ALIASES.get(cell.lower(), cell.lower())
        if name in places:
            problems.append(Problem(cell, "the column a second time", "every column once", 1))
        elif name in COLUMNS:
            places[name] = place
        elif cell or place < max((p for p, c in enumerate(cells) if c), default=0):
            shown = cell or f"number {place + 1}"
            problems.append(Problem(shown, "a column that is not known", f"one of {', '.join(COLUMNS)}", 1))
    for name in REQUIRED:
        if name not in places:
            problems.append(Problem(name, "no such column", "it in the header", 1))
    if "distance" not in places and "layup" not in places:
        problems.append(Problem("distance", "no such column", "it in the header, or layup", 1))
    if problems:
        raise JobsError(source, problems)
    return places


def _job(row: int, texts: Mapping[str, str]) -> Tuple[Job, List[Problem]]:
    """The job of a row, with None for what is wrong, and the problems."""
    problems: List[Problem] = []

    def value(name: str, parse: Any, expected: str) -> Any:
        try:
            return parse(texts.get(name, ""))
        except ValueError:
            problems.append(Problem(name, quoted(texts.get(name, "")), expected, row))
            return None

    length = number(-MAX_LENGTH, MAX_LENGTH, optional=True)
    positive = number(0.0, MAX_LENGTH, above=True, optional=True)
    job = Job(
        row,
        value("input", _path, "the name of a STEP, IGES, BREP or FCStd file") or "",
        value("face", _face, "a face number from 1, or all"),
        value(
            "distance",
            length,
            f"a number of mm from {-MAX_LENGTH:g} to {MAX_LENGTH:g}, or nothing where a layup is given",
        ),
        value("layup", text, "the name of a layup table or document, or nothing where a distance is given") or "",
        value("tolerance", positive, f"a number of mm above 0, at most {MAX_LENGTH:g}, or nothing"),
        value("output", _output, f"a file name within the folder of results, ending in one of {', '.join(FORMATS)}")
        or "",
        value("boundaries", text, "the name of a STEP, IGES, BREP or FCStd file, or nothing") or "",
        value("side", _entries(parse_side), f"NAME=SIDE with one of {', '.join(SIDES)}, more of them after |") or (),
        value("drop_off", _drop_off, "a multiple of a ply's thickness, a length such as 5mm, or nothing") or "",
        value("ramp_slope", _ramp_slope, f"one of {', '.join(RAMP_SLOPES)}, or nothing") or "",
        value("stagger", _entries(parse_stagger), "NAME=D,D,... with distances in mm, more of them after |") or (),
        value("boundary_gap", number(0.0, MAX_LENGTH, optional=True), "a number of mm, zero or more, or nothing"),
    )
    return job, problems or _together(job)


def _together(job: Job) -> List[Problem]:
    """What is wrong with a row whose cells are right by themselves."""
    if job.distance is not None and job.layup:
        return [Problem("layup", quoted(job.layup), "either a distance or a layup, not both", job.row)]
    if job.distance is None and not job.layup:
        return [Problem("distance", "nothing", "a number of mm, or a layup", job.row)]
    if job.layup and job.face is None:
        return [Problem("face", "'all'", "a face number: a stack lies on one face", job.row)]
    told = [name for name in BOUNDING if name in job.task()]
    if told and not job.layup:
        return [Problem(told[0], quoted(_shown(job, told[0])), "nothing where no layup is given", job.row)]
    if job.side and not job.boundaries:
        return [Problem("side", quoted(_shown(job, "side")), "nothing where no boundaries are given", job.row)]
    return []


def _shown(job: Job, name: str) -> str:
    value = getattr(job, name)
    return BETWEEN.join(value) if isinstance(value, tuple) else str(value)


def _overfull(row: int, cells: Sequence[str], width: int) -> List[Problem]:
    return [
        Problem("", f"{quoted(cell)} in cell {place}", f"{width} cells, as in the header", row)
        for place, cell in enumerate(cells, start=1)
        if place > width and cell
    ]


def _repeated_outputs(jobs: Sequence[Job]) -> List[Problem]:
    """Outputs that two rows have; letters of either case may be one file."""
    first: Dict[str, int] = {}
    problems = []
    for job in jobs:
        row = first.setdefault(os.path.normpath(job.output).lower(), job.row)
        if job.output and row != job.row:
            expected = f"a file of its own; row {row} has the same"
            problems.append(Problem("output", quoted(job.output), expected, job.row))
    return problems


def _path(value: str) -> str:
    if not text(value):
        raise ValueError
    return text(value)


def _face(value: str) -> Optional[int]:
    if value.strip().lower() == "all":
        return None
    if not value.strip().isascii() or not value.strip().isdigit() or not 1 <= int(value) <= 10**9:
        raise ValueError
    return int(value)


def _entries(parse: Callable[[str], Any]) -> Callable[[str], Tuple[str, ...]]:
    """Of one cell."""

    def entries(value: str) -> Tuple[str, ...]:
        found = tuple(part.strip() for part in text(value).split(BETWEEN) if part.strip())
        for entry in found:
            parse(entry)
        return found

    return entries


def _drop_off(value: str) -> str:
    if text(value):
        drop_off_of(parse_drop_off(text(value)))
    return text(value)


def _ramp_slope(value: str) -> str:
    if text(value) and text(value) not in RAMP_SLOPES:
        raise ValueError
    return text(value)


def _output(value: str) -> str:
    name = os.path.normpath(_path(value))
    known = os.path.splitext(name)[1].lower() in FORMATS
    if not known or os.path.isabs(name) or name.split(os.sep)[0] == os.pardir:
        raise ValueError
    return text(value)
