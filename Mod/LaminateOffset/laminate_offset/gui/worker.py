# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in another thread. The engine computes without Python's lock, so that the GUI goes on."""

import _thread
import threading
from typing import Any, Callable, Optional

from .. import _core
from ..features.progress import Work
from . import preferences

#: By how much the engine steps back behind the GUI where both want a processor core (niceness). Only the engine does: a
#: thread that steps back while it runs Python would hold up all of Python, the GUI too.
_NICENESS = 10


class Job:
    """One piece of work in a thread of its own, started at once."""

    def __init__(self, work: Work):
        self._work = work
        self._progress = _core.Progress()
        self._value: Any = None
        self._error: Optional[BaseException] = None
        self._done = threading.Event()
        preferences.apply()
        # A threading.Thread would make the GUI wait until the other thread has run for the first time.
        _thread.start_new_thread(self._run, ())

    @property
    def fraction(self) -> float:
        """How far it is, from 0 to 1."""
        return float(self._progress.fraction)

    def wait(self, seconds: float = 0.0) -> bool:
        """Whether the work has ended; waits for that so long at most."""
        return self._done.wait(seconds)

    def cancel(self) -> None:
        """Asks the work to end soon."""
        self._progress.cancel()

    @property
    def cancelled(self) -> bool:
        """Whether it was asked to end."""
        return bool(self._progress.cancelled)

    def result(self) -> Any:
        """What the work returned, once it has ended; raises what it raised."""
        if self._error is not None:
            raise self._error
        return self._value

    def _run(self) -> None:
        _core.set_engine_niceness(_NICENESS)
        try:
            self._value = self._work(self._progress)
        except BaseException as error:  # handed to the thread that asks for the result
            self._error = error
        finally:
            self._done.set()


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
