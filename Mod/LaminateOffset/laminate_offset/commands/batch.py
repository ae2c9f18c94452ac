# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset batch: the jobs of a table."""

import argparse
import os
from collections import Counter
from typing import Any, List, TextIO

from ..batch import Outcome, read_jobs, run_batch
from . import CANCELLED, DONE, REFUSED
from .bar import Bar


def add_to(commands: Any) -> None:
    """Describes the command to the parser."""
    parser = commands.add_parser(
        "batch",
        help="carry out a table of jobs, several at a time",
        description="Carries out the jobs of a table: CSV with the columns input, face, distance or layup, tolerance and "
        "output, one row a job. A job that fails is recorded with its reason, and the others go on. Running it again "
        "skips what is done; Ctrl-C stops it and keeps what is done.",
        epilog="DIR gets the outputs, a record for each (OUTPUT.json) and summary.csv with a row a job. Exit codes: 0 all "
        "done; 1 a job failed; 2 a wrong table; 130 cancelled.",
    )
    parser.set_defaults(command=run)
    add = parser.add_argument
    add("jobs", metavar="JOBS.csv", help="the table; paths in it start at its own folder")
    add("-o", "--output", required=True, metavar="DIR", help="folder of the results; it is made if it is missing")
    add(
        "--workers",
        type=_worker_count,
        default=len(os.sched_getaffinity(0)),
        metavar="K",
        help="how many jobs to carry out at the same time, each in a process of its own (default: the number of processor "
        "cores, %(default)s here)",
    )


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    count = len(read_jobs(arguments.jobs))
    known: List[Outcome] = []
    with Bar(count, err, "batch") as bar:

        def told(outcome: Outcome, done: int, _of: int) -> None:
            known.append(outcome)
            _tell(outcome, bar, out, err)
            bar.show(done)

        try:
            run_batch(arguments.jobs, arguments.output, arguments.workers, told)
        except KeyboardInterrupt:
            bar.write(f"laminate-offset: cancelled; {_counted(known, count)}. Run it again to go on.", err)
            return CANCELLED
    print(f"laminate-offset: {_counted(known, count)}; see {os.path.join(arguments.output, 'summary.csv')}", file=err)
    return DONE if all(outcome.state == "done" for outcome in known) else REFUSED


def _tell(outcome: Outcome, bar: Bar, out: TextIO, err: TextIO) -> None:
    place = f"row {outcome.job.row}: {outcome.job.output}"
    if outcome.reason:
        bar.write(f"laminate-offset: {place}: {outcome.state}: {outcome.reason}", err)
    else:
        bar.write(f"{place}: {outcome.state}{' before' if outcome.skipped else ''}", out)


def _counted(known: List[Outcome], count: int) -> str:
    """E.g. "7 of 9 jobs done (4 of them before), 1 failed"."""
    states = Counter(outcome.state for outcome in known)
    before = sum(1 for outcome in known if outcome.skipped)
    text = f"{states.pop('done', 0)} of {count} jobs done" + (f" ({before} of them before)" if before else "")
    return ", ".join([text, *(f"{number} {state}" for state, number in sorted(states.items()))])


def _worker_count(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number") from None
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number}: at least one worker is needed")
    return number
