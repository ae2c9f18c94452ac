# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in another thread. The engine computes without Python's lock, so that the GUI goes on."""

import os
import sys
import threading
from typing import Any, Callable, Optional

from ..features.progress import Report, Work
from . import preferences


#: By how much work steps behind the GUI where both want a processor core (niceness).
_NICENESS = 5


def _step_back() -> None:
    """Linux gives every thread a priority of its own; threads that the engine starts from this one inherit it."""
    if sys.platform.startswith("linux"):
        try:
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), os.getpriority(os.PRIO_PROCESS, 0) + _NICENESS)
        except OSError:
            pass  # a wish, no need


class Job:
    """One piece of work in a thread of its own, started at once.

    Attributes:
        fraction: how far it is, from 0 to 1.
    """

    def __init__(self, work: Work):
        self.fraction = 0.0
        self._work = work
        self._cancelled = False
        self._value: Any = None
        self._error: Optional[BaseException] = None
        self._done = threading.Event()
        preferences.apply()
        self._thread = threading.Thread(target=self._run, name="LaminateOffset", daemon=True)
        self._thread.start()

    def wait(self, seconds: float = 0.0) -> bool:
        """Whether the work has ended; waits for that so long at most."""
        return self._done.wait(seconds)

    def cancel(self) -> None:
        """Asks the work to end soon."""
        self._cancelled = True

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""
        return self._cancelled

    def result(self) -> Any:
        """What the work returned, once it has ended; raises what it raised."""
        if self._error is not None:
            raise self._error
        return self._value

    def _run(self) -> None:
        _step_back()
        report: Report = self._report
        try:
            self._value = self._work(report)
        except BaseException as error:  # handed to the thread that asks for the result
            self._error = error
        finally:
            self._done.set()

    def _report(self, fraction: float) -> bool:
        self.fraction = fraction
        return not self._cancelled


class Newest:
    """Runs one job at a time and only the newest: a new one cancels what runs, and takes the place of what waits.

    poll() is called by a timer of the GUI's thread, in which `finished` is called with the job.
    """

    def __init__(self, finished: Callable[[Job], None]):
        self._finished = finished
        self._running: Optional[Job] = None
        self._waiting: Optional[Work] = None

    @property
    def busy(self) -> bool:
        """Whether anything runs or waits."""
        return self._running is not None or self._waiting is not None

    @property
    def fraction(self) -> float:
        """How far what runs is, from 0 to 1."""
        return 0.0 if self._running is None else self._running.fraction

    def start(self, work: Work) -> None:
        """Does the work as soon as what runs has ended."""
        self.cancel()
        self._waiting = work
        self.poll()

    def cancel(self) -> None:
        """Ends what runs, forgets what waits; neither is reported."""
        self._waiting = None
        if self._running is not None:
            self._running.cancel()

    def poll(self) -> None:
        """Reports a finished job and starts the waiting one."""
        job = self._running
        if job is not None and job.wait():
            self._running = None
            if not job.cancelled:
                self._finished(job)
        if self._running is None and self._waiting is not None:
            work, self._waiting = self._waiting, None
            self._running = Job(work)
