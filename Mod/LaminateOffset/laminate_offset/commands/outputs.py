# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that a command writes: found out before the work whether it can."""

import os
from typing import Optional, Sequence, TextIO

import Part

from ..each_face import FaceOutcome
from ..files import check_writable, format_of, write_json, write_shape
from ..replacing import FileError
from . import DONE, REFUSED


def default_output(source: str, what: str) -> str:
    """The output's name when none is given: the input's own, in the current folder."""
    return os.path.splitext(os.path.basename(source))[0] + f"_{what}.step"


def check_outputs(source: str, output: str, report: Optional[str]) -> None:
    """Finds out before the work whether its results can be kept, and that they replace neither input nor each other."""
    format_of(output)
    check_results([source], [output, report])


def check_results(sources: Sequence[str], results: Sequence[Optional[str]]) -> None:
    """As check_outputs, for any number of files that are read and written; None stands for one that is not wanted."""
    wanted = [path for path in results if path is not None]
    for place, path in enumerate(wanted):
        if any(is_same_file(path, source) for source in sources):
            raise FileError(f"{path}: is the input; name another file for the result.")
        if any(is_same_file(path, other) for other in wanted[:place]):
            raise FileError(f"{path}: is also the output of another option; give it a name of its own.")
        check_writable(path)


def is_same_file(first: str, second: str) -> bool:
    """Whether two paths lead to one file, existing or not."""
    if os.path.exists(first) and os.path.exists(second):
        return os.path.samefile(first, second)
    return os.path.realpath(first) == os.path.realpath(second)


def write_outcomes(
    outcomes: Sequence[FaceOutcome], one: bool, output: str, label: str, report: Optional[str], err: TextIO
) -> int:
    """Writes the faces that succeeded, if any, and the reports of all; returns the exit code.

    one: a single face was asked for; otherwise the output is a compound and the report a list.
    """
    shapes = [outcome.shape for outcome in outcomes if outcome.shape is not None]
    if shapes:
        write_shape(shapes[0] if one else Part.Compound(shapes), output, label)
        print(f"laminate-offset: wrote {output}", file=err)
    if report:
        reports = [{"face": outcome.number, **outcome.report.to_dict()} for outcome in outcomes]
        write_json(reports[0] if one else reports, report)
    return DONE if len(shapes) == len(outcomes) else REFUSED
