# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summary of a batch: CSV with one row a job, in the order of the table."""

import csv
import os
from typing import Any, Iterable

from ..replacing import replacing
from .jobs import SUMMARY

FIGURES = ("count", "certified_error", "edge_error", "elapsed_ms")
HEADER = ("row", "input", "face", "distance", "layup", "tolerance", "output", "state", "skipped", "reason", *FIGURES)


def write_summary(outcomes: Iterable[Any], folder: str) -> None:
    """Writes DIR/summary.csv in one step.

    Its columns are the row's number and cells, the state (done, partly done, failed, not run), whether it was skipped
    because it was done before, the reason of a failure, and figures: how many faces or plies, the largest proven errors
    in mm, and the time in ms.
    """
    with replacing(os.path.join(folder, SUMMARY)) as temporary:
        with open(temporary, "w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream, lineterminator="\n")
            writer.writerow(HEADER)
            for outcome in outcomes:
                writer.writerow([_cell(value) for value in _row(outcome)])


def _row(outcome: Any) -> Iterable[Any]:
    job = outcome.job
    yield from (job.row, job.input, "all" if job.face is None else job.face, job.distance, job.layup, job.tolerance)
    yield from (job.output, outcome.state, "yes" if outcome.skipped else "no", outcome.reason)
    yield from (outcome.figures.get(name) for name in FIGURES)


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else " ".join(str(value).splitlines())
