# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a recompute tells its progress without knowing the GUI.

The GUI installs a runner, which keeps its event loop alive meanwhile; without one, work simply runs to its end.
"""

from typing import Any, Callable, Optional

from .. import _core

#: Called with a fraction from 0 to 1; returns False to cancel.
Report = Callable[[float], bool]

#: A piece of work: gets a Report, or None when nobody watches, and returns its result.
Work = Callable[[Optional[Report]], Any]

#: Given a title and a piece of work, does it and returns its result. It may do it in another thread.
Runner = Callable[[str, Work], Any]

_runner: Optional[Runner] = None


def install(runner: Optional[Runner]) -> None:
    """Lets runner do the work of every later recompute; None: it is done at once, and nobody watches."""
    global _runner
    _runner = runner


def run(title: str, work: Work) -> Any:
    """Does the work and returns its result. The work must not touch a document: it may run in another thread."""
    return work(None) if _runner is None else _runner(title, work)


def part_of(report: Optional[Report], index: int, count: int) -> Optional[Report]:
    """The Report of the index-th of count equal steps."""
    if report is None:
        return None
    if isinstance(report, _core.Progress):
        part: Report = report.part(index, count)
        return part
    return lambda fraction: report((index + fraction) / count)
