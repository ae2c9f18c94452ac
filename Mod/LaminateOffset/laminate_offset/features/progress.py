# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a recompute tells its progress without knowing the GUI.

The GUI installs a watcher; without one, long work simply runs to its end.
"""

import contextlib
import threading
from typing import Callable, ContextManager, Iterator, Optional

#: Called with a fraction from 0 to 1; returns False to cancel.
Report = Callable[[float], bool]

#: Given a title, a context manager that shows progress and yields a Report.
Watcher = Callable[[str], ContextManager[Report]]

_watcher: Optional[Watcher] = None


def install(watcher: Optional[Watcher]) -> None:
    """Shows the progress of every later recompute with watcher; None shows nothing."""
    global _watcher
    _watcher = watcher


@contextlib.contextmanager
def watch(title: str) -> Iterator[Optional[Report]]:
    """Yields the Report for one piece of work, or None when nobody watches."""
    if _watcher is None:
        yield None
        return
    with _watcher(title) as report:
        yield _in_this_thread(report)


def part_of(report: Optional[Report], index: int, count: int) -> Optional[Report]:
    """The Report of the index-th of count equal steps."""
    if report is None:
        return None
    return lambda fraction: report((index + fraction) / count)


def _in_this_thread(report: Report) -> Report:
    """Widgets belong to one thread, while the engine may call from any: others get the last answer."""
    owner = threading.get_ident()
    keep_going = True

    def guarded(fraction: float) -> bool:
        nonlocal keep_going
        if threading.get_ident() == owner:
            keep_going = keep_going and report(fraction)
        return keep_going

    return guarded
