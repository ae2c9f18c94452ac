# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hands the jobs of a table to worker processes, so that one that crashes takes nobody along."""

import fcntl
import json
import os
import queue
import signal
import subprocess
import sys
import threading
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

from ..layup.errors import Problem
from ..replacing import FileError, remove_leftovers
from .jobs import Job, JobsError, read_jobs, resolve
from .records import FAILED, NOT_RUN, digest, done_before, make_record, write_record
from .summary import write_summary
from .worker import COMMAND, READY

# How long a worker may take to stop: an engine's step or the writing of a file comes to its end.
STOP_SECONDS = 10.0


@dataclass(frozen=True)
class Outcome:
    """What became of a job.

    Attributes:
        job: the row.
        state: "done", "partly done" (some of all faces were refused), "failed", or "not run" after Ctrl-C.
        reason: why it failed, or which faces were refused; "" otherwise.
        figures: "count" (faces or plies), "certified_error" and "edge_error" in mm, "elapsed_ms"; as far as known.
        skipped: whether it was done before and nothing had changed.
    """

    job: Job
    state: str
    reason: str = ""
    figures: Dict[str, Any] = field(default_factory=dict)
    skipped: bool = False


def run_batch(
    table: str, folder: str, workers: int = 1, told: Optional[Callable[[Outcome, int, int], None]] = None
) -> List[Outcome]:
    """Carries out the jobs of a table, except those that are done already.

    A job is done when its output and its record (OUTPUT.json) exist and its row and files are unchanged. A job that
    fails is recorded with its reason, and the others go on. summary.csv in the folder has a row a job; it is written at
    the end, also after Ctrl-C, which stops the jobs at work and keeps what is done.

    Args:
        table: the table of jobs, see read_jobs.
        folder: where the results are written; it is made if it is missing.
        workers: how many processes work at the same time, at least 1.
        told: called with every outcome as it becomes known, the number of those that are known, and the number of jobs.

    Returns:
        The outcomes in the order of the table.

    Raises:
        JobsError: the table is wrong; it names row and column, and nothing was started.
        FileError: the folder cannot be used.
        KeyboardInterrupt: Ctrl-C, after everything was stopped and the summary written.
    """
    if workers < 1:
        raise ValueError(f"workers must be at least 1; it is {workers}.")
    jobs = read_jobs(table)
    orders = [_order(job, os.path.dirname(os.path.abspath(table)), folder) for job in jobs]
    _check_outputs(table, orders)
    with _alone_in(folder):
        try:
            return _Run(orders, folder, told).go(workers)
        finally:
            for output in {os.path.dirname(order.paths["output"]) for order in orders}:
                remove_leftovers(output)


@dataclass(frozen=True)
class _Order:
    """A job with its files."""

    job: Job
    paths: Dict[str, str]

    def digests(self, known: Dict[str, Optional[str]]) -> Dict[str, Optional[str]]:
        """The digests of the files that it reads; known ones are not computed again."""
        sources = {name: path for name, path in self.paths.items() if name != "output"}
        for path in sources.values():
            if path not in known:
                known[path] = digest(path)
        return {name: known[path] for name, path in sources.items()}


class _Run:
    """One run of a batch: what is known of every job, and the processes at work."""

    def __init__(self, orders: List[_Order], folder: str, told: Optional[Callable[[Outcome, int, int], None]]) -> None:
        self._orders = orders
        self._folder = folder
        self._told = told
        self._outcomes: Dict[int, Outcome] = {}
        self._waiting: "queue.SimpleQueue[Tuple[_Order, Dict[str, Optional[str]]]]" = queue.SimpleQueue()
        self._known: "queue.Queue[Any]" = queue.Queue()
        self._processes: List["subprocess.Popen[str]"] = []
        self._lock = threading.Lock()
        self._stopped = False
        self._threads = 1
        self._servers: List[threading.Thread] = []

    def go(self, workers: int) -> List[Outcome]:
        """Runs everything that is not done; writes the summary however it ends."""
        try:
            count = self._sort_out()
            workers = min(workers, count)
            # The processes share the cores: what one job could do in parallel, the others need.
            self._threads = max(1, len(os.sched_getaffinity(0)) // max(1, workers))
            self._servers = [threading.Thread(target=self._serve, daemon=True) for _ in range(workers)]
            for server in self._servers:
                server.start()
            for _ in range(count):
                self._learn(self._known.get())
            for server in self._servers:
                server.join()
        except BaseException:
            self._stop()
            raise
        finally:
            self._write_summary()
        return self._all()

    def _sort_out(self) -> int:
        """Tells which jobs are done and queues the others; returns how many these are."""
        known: Dict[str, Optional[str]] = {}
        count = 0
        for order in self._orders:
            digests = order.digests(known)
            record = done_before(order.job, digests, order.paths["output"])
            if record is None:
                self._waiting.put((order, digests))
                count += 1
            else:
                self._learn(Outcome(order.job, record["state"], record["reason"], record["figures"], True))
        return count

    def _learn(self, outcome: Any) -> None:
        if isinstance(outcome, BaseException):
            raise outcome
        self._outcomes[outcome.job.row] = outcome
        if self._told is not None:
            self._told(outcome, len(self._outcomes), len(self._orders))

    def _serve(self) -> None:
        """A thread: keeps one worker process at work until nothing waits any more."""
        # Workers inherit that Ctrl-C has to wait, until they are ready for it.
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        process: Optional["subprocess.Popen[str]"] = None
        try:
            while not self._stopped:
                try:
                    order, digests = self._waiting.get_nowait()
                except queue.Empty:
                    break
                if process is None:
                    process = self._start()
                answer = _ask(process, order, digests)
                if answer is None and self._stopped:
                    break
                if answer is None:
                    _dismiss(process)
                    answer = _crashed(process, order, digests)
                    process = None
                self._known.put(Outcome(order.job, answer["state"], answer["reason"], answer["figures"]))
        except BaseException as error:  # the main thread waits for this one's outcomes
            self._known.put(error)
        finally:
            if process is not None:
                _dismiss(process)

    def _start(self) -> "subprocess.Popen[str]":
        """A new worker, in a session of its own: a Ctrl-C at the terminal reaches it through us only."""
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
        with self._lock:
            if self._stopped:
                raise KeyboardInterrupt
            process = subprocess.Popen(
                [sys.executable, "-c", COMMAND, str(self._threads)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                env=environment,
                start_new_session=True,
                encoding="utf-8",
            )
            self._processes.append(process)
        assert process.stdout is not None
        if READY not in process.stdout and not self._stopped:  # lines before it are FreeCAD's
            raise FileError(f"{sys.executable}: a worker process could not be started; its message is above.")
        return process

    def _stop(self) -> None:
        """Ends the workers: first by Ctrl-C, which lets them clean up, and after a while in any case."""
        with self._lock:
            self._stopped = True
        for process in self._processes:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in self._processes:
            try:
                process.wait(STOP_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        for server in self._servers:
            server.join(STOP_SECONDS)

    def _all(self) -> List[Outcome]:
        return [self._outcomes.get(order.job.row, Outcome(order.job, NOT_RUN)) for order in self._orders]

    def _write_summary(self) -> None:
        write_summary(self._all(), self._folder)


def _ask(
    process: "subprocess.Popen[str]", order: _Order, digests: Dict[str, Optional[str]]
) -> Optional[Dict[str, Any]]:
    """What a worker says when it has carried out a job; None when it has ended instead."""
    assert process.stdin is not None and process.stdout is not None
    try:
        process.stdin.write(json.dumps({"task": order.job.task(), "paths": order.paths, "digests": digests}) + "\n")
        process.stdin.flush()
    except BrokenPipeError:
        return None
    line = process.stdout.readline()
    answer: Optional[Dict[str, Any]] = json.loads(line) if line.endswith("\n") else None
    return answer


def _dismiss(process: "subprocess.Popen[str]") -> None:
    """Lets a worker end, or waits for the end of one that is ending."""
    assert process.stdin is not None
    with suppress(BrokenPipeError):  # it has ended with an order on its way
        process.stdin.close()
    process.wait()


def _crashed(process: "subprocess.Popen[str]", order: _Order, digests: Dict[str, Optional[str]]) -> Dict[str, Any]:
    """The outcome of a job whose worker has ended in the middle of it; it is recorded."""
    code = process.returncode
    how = signal.strsignal(-code) if code < 0 else f"exit code {code}"
    reason = f"the process that worked on it ended early ({how})"
    record = make_record(order.job.task(), digests, FAILED, reason, figures={}, report=None)
    write_record(record, order.paths["output"])
    return record


def _order(job: Job, table_folder: str, folder: str) -> _Order:
    paths = {"input": resolve(job.input, table_folder), "output": os.path.abspath(os.path.join(folder, job.output))}
    if job.layup:
        paths["layup"] = resolve(job.layup, table_folder)
    if job.boundaries:
        paths["boundaries"] = resolve(job.boundaries, table_folder)
    return _Order(job, paths)


def _check_outputs(table: str, orders: List[_Order]) -> None:
    """No job may write over a file that one of them reads."""
    read = {os.path.realpath(path) for order in orders for name, path in order.paths.items() if name != "output"}
    problems = [
        Problem("output", repr(order.job.output), "a file that no job reads", order.job.row)
        for order in orders
        if os.path.realpath(order.paths["output"]) in read
    ]
    if problems:
        raise JobsError(table, problems)


@contextmanager
def _alone_in(folder: str) -> Iterator[None]:
    """Makes the folder and keeps other batches out of it. The system opens the door again however we end."""
    try:
        os.makedirs(folder, exist_ok=True)
        door = os.open(folder, os.O_RDONLY)
    except OSError as error:
        raise FileError(f"{folder}: cannot be used for results: {error.strerror}.") from error
    try:
        try:
            fcntl.flock(door, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise FileError(f"{folder}: another batch is working in this folder; wait until it ends.") from error
        yield
    finally:
        os.close(door)
