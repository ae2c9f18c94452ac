# SPDX-License-Identifier: LGPL-2.1-or-later
"""The event loop goes on during live previews, up to their results, on the largest faces of the data that can be offset."""

import os
import threading
import time

import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui
from session import (
    OUT,
    click,
    look_at_all,
    press,
    pump,
    result_text,
    run_command,
    screenshot,
    select,
    start,
    type_into,
    wait_until,
)

BUTTON = QtGui.QDialogButtonBox
DATA = os.path.join(os.path.dirname(os.environ["LAMINATE_OFFSET_PROJECT_DIR"]), "shared", "data")

#: File, first distance, another one that cancels it [mm]. The offset of bladex_lower has 6838 poles, that of the blade of iea15 8476.
FACES = (("iea15_CFD.igs", "7 mm", "-5 mm"), ("bladex_lower.iges", "0.000001 mm", "-0.000002 mm"))
LIMIT_S = 0.1
#: For all previews together: a busy machine may need minutes for the largest face.
BUDGET_S = 215.0
ATTEMPTS = 3
#: In which a new preview has begun: the panel waits for more keys first.
DELAY_MS = 800


def run() -> None:
    """Called by scenario_runner.py."""
    deadline = time.perf_counter() + BUDGET_S
    for name, first, second in FACES:
        doc = start()
        base = doc.addObject("Part::Feature", "Base")
        base.Shape = Part.read(os.path.join(DATA, name)).Faces[0]
        doc.recompute()
        look_at_all()
        preview(name, base, first, second, deadline)


class Pulse:
    """A timer of the event loop that measures how late it is called.

    Each pause comes as (all of it, without the time in which the thread waited for a processor core that other programs
    had): the second is what our own code is answerable for.
    """

    def __init__(self) -> None:
        self.pauses = []
        self._timer = QtCore.QTimer()
        self._timer.setInterval(5)
        self._timer.timeout.connect(self._beat)
        self._last = now()
        self._timer.start()

    def stop(self) -> tuple:
        """The longest pause in seconds, all of it and our own."""
        self._timer.stop()
        assert len(self.pauses) > 50
        return max(whole for whole, _ in self.pauses), max(own for _, own in self.pauses)

    def _beat(self) -> None:
        last, self._last = self._last, now()
        whole, waited = (new - old for new, old in zip(self._last, last))
        self.pauses.append((whole, whole - waited))


class Ear:
    """A thread that does nothing but ask for Python's lock: whoever holds that for long would hold up the GUI's own code too.

    Each wait is without the time in which the thread waited for a processor core.
    """

    def __init__(self) -> None:
        self._waits = []
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()

    def stop(self) -> float:
        """The longest wait in seconds."""
        self._over.set()
        self._thread.join()
        assert len(self._waits) > 50
        return max(self._waits)

    def _listen(self) -> None:
        last = now()
        while not self._over.is_set():
            time.sleep(0.005)
            new = now()
            self._waits.append((new[0] - last[0]) - (new[1] - last[1]))
            last = new


def now() -> tuple:
    """The time, and how long this thread has waited for a processor core so far, in seconds."""
    with open("/proc/thread-self/schedstat", encoding="ascii") as file:
        return time.perf_counter(), int(file.read().split()[1]) * 1e-9


def finished(deadline: float) -> bool:
    """Whether the preview ends with a result before the deadline."""
    while "Computing" in result_text() and time.perf_counter() < deadline:
        pump(20)
    return "poles" in result_text()


def preview(name: str, base, first: str, second: str, deadline: float) -> None:
    """Two distances, the first of which is cancelled by the second, whose result is awaited.

    On a busy machine it is tried again, but a result is needed once only; where the loop stands still even with nothing to
    compute, that is the measure.
    """
    select(base, "Face1")
    run_command()
    idle = idle_pause(first, second)
    click("livePreview")
    pauses, locks, results = [], [], []
    while (
        len(pauses) < ATTEMPTS
        and min(pauses, default=1.0) >= LIMIT_S
        and (not results or time.perf_counter() < deadline)
    ):
        ended, whole, own, lock = longest_pause(first, second, deadline)
        results.append(ended)
        pauses.append(own)
        locks.append(lock)
        note(
            f"{name}: longest pause {1000 * whole:.0f} ms, own {1000 * own:.0f} ms, Python's lock {1000 * lock:.0f} ms; "
            f"{result_text()}"
        )
    screenshot(name.split(".", maxsplit=1)[0])
    note(f"{name}: longest own pause with nothing to compute {1000 * idle:.0f} ms")
    assert any(results), f"{name}: no preview came to a result: {result_text()}"
    assert min(locks) < LIMIT_S, f"{name}: Python's lock was held for {locks} s"
    assert min(pauses) < max(LIMIT_S, 2 * idle), f"{name}: the event loop stood still for {pauses} s, idle {idle} s"
    began = time.perf_counter()
    press(BUTTON.Cancel)
    assert time.perf_counter() - began < 5 and not Gui.Control.activeDialog()


def note(line: str) -> None:
    """Keeps a figure."""
    with open(os.path.join(OUT, "figures.txt"), "a", encoding="utf-8") as file:
        file.write(line + "\n")


def idle_pause(first: str, second: str) -> float:
    """The longest pause of our own while distances are typed and nothing is computed."""
    pulse = Pulse()
    for _ in range(5):
        type_into("distance", first)
        type_into("distance", second)
    pump(1000)
    return pulse.stop()[1]


def longest_pause(first: str, second: str, deadline: float) -> tuple:
    """Whether the second preview came to a result; the longest pause of the event loop in seconds, all of it and our own; and
    the longest wait for Python's lock."""
    pulse, ear = Pulse(), Ear()
    type_into("distance", first)
    wait_until(lambda: "Computing" in result_text(), "the preview to begin")
    type_into("distance", second)
    pump(DELAY_MS)  # until then the line may still show the first one's result
    ended = finished(deadline)
    return (ended, *pulse.stop(), ear.stop())
