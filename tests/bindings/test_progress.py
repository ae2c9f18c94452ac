# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress, cancelling, Ctrl-C, and other Python threads running on during a computation."""

import signal
import threading
import time
from typing import List

import laminate_offset as lo
import pytest
import sample_shapes
from laminate_offset import _core

DISTANCE, TIGHT = 5.0, 1e-7


@pytest.fixture(scope="module")
def heavy():
    """A face whose offset takes a good while, which the test of threads checks."""
    return sample_shapes.heavy_face()


def test_other_threads_run_during_the_computation(heavy) -> None:
    ticks: List[float] = []
    stop = threading.Event()

    def tick() -> None:
        while not stop.wait(0.001):
            ticks.append(time.perf_counter())

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.perf_counter()
    try:
        lo.offset_face(heavy, DISTANCE, TIGHT)
    finally:
        end = time.perf_counter()
        stop.set()
        thread.join()
    duration = end - start
    assert duration > 0.02, "the computation is too short to tell anything"
    middle = [moment for moment in ticks if start + 0.2 * duration < moment < end - 0.2 * duration]
    assert len(middle) >= 5


def test_two_threads_offset_at_the_same_time() -> None:
    base = sample_shapes.trimmed_bspline_face()
    expected = lo.offset_face(base, 2.0).face.exportBrepToString()
    results: List[str] = []
    threads = [
        threading.Thread(target=lambda: results.append(lo.offset_face(base, 2.0).face.exportBrepToString()))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    base.tessellate(0.01)
    for thread in threads:
        thread.join()
    assert results == [expected] * 4


def test_progress_rises_from_zero_to_one(heavy) -> None:
    fractions: List[float] = []
    lo.offset_face(heavy, DISTANCE, TIGHT, progress=fractions.append)
    assert len(fractions) >= 2
    assert fractions == sorted(fractions)
    assert (fractions[0], fractions[-1]) == (0.0, 1.0)


def test_a_false_answer_at_the_end_cancels_too() -> None:
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(sample_shapes.sphere_face(), 1.0, progress=lambda fraction: fraction < 1.0)
    assert caught.value.status == "cancelled"


@pytest.mark.parametrize("answer", [None, True, 1])
def test_any_answer_but_a_false_one_goes_on(answer) -> None:
    assert lo.offset_face(sample_shapes.bspline_face(), 1.0, progress=lambda _: answer).report.status == "ok"


@pytest.mark.parametrize("make", [sample_shapes.bspline_face, sample_shapes.sphere_face])
@pytest.mark.parametrize("answer", [False, 0])
def test_a_false_answer_cancels(make, answer) -> None:
    calls: List[float] = []

    def stop(fraction: float) -> object:
        calls.append(fraction)
        return answer

    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(make(), 1.0, progress=stop)
    assert caught.value.status == caught.value.report.status == "cancelled"
    assert len(calls) == 1


def test_what_progress_raises_is_raised() -> None:
    class Unwell(Exception):
        pass

    def fail(_fraction: float) -> None:
        raise Unwell("as told")

    with pytest.raises(Unwell, match="as told"):
        lo.offset_face(sample_shapes.bspline_face(), 1.0, progress=fail)


def test_progress_must_be_callable() -> None:
    with pytest.raises(TypeError, match="progress must be None or a callable"):
        lo.offset_face(sample_shapes.bspline_face(), 1.0, progress=3)


def test_progress_from_another_thread() -> None:
    seen: List[int] = []
    thread = threading.Thread(
        target=lambda: lo.offset_face(
            sample_shapes.bspline_face(), 1.0, progress=lambda _: seen.append(threading.get_ident())
        )
    )
    thread.start()
    thread.join()
    assert seen


def test_ctrl_c_stops_the_computation(heavy) -> None:
    start = time.perf_counter()
    lo.offset_face(heavy, DISTANCE, TIGHT)
    usual = time.perf_counter() - start
    fractions: List[float] = []
    previous = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2 * usual)
        with pytest.raises(KeyboardInterrupt):
            lo.offset_face(heavy, DISTANCE, TIGHT, progress=lambda fraction: fractions.append(fraction) or True)
            pytest.fail("the computation went to its end")
        assert max(fractions) < 1.0  # stopped on the way, not at the final report
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous)


def test_processor_cores_can_be_limited():
    face = lo.api.Part.makeSphere(10.0).Faces[0]
    try:
        for count in (1, 2, 0):
            _core.limit_threads(count)
            assert lo.offset_face(face, 1.0).report.status == "ok"
        with pytest.raises(ValueError, match="0, for all"):
            _core.limit_threads(-1)
    finally:
        _core.limit_threads(0)


def test_searches_let_other_threads_run():
    """A counting thread goes on while nearest_point works."""
    face = sample_shapes.bspline_face()
    points = [(0.01 * i % 50, 0.013 * i % 50, 3.0) for i in range(20000)]
    turns, stop = [0], threading.Event()

    def count() -> None:
        while not stop.is_set():
            turns[0] += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    time.sleep(0.02)
    before = turns[0]
    lo.nearest_point(face, points)
    during = turns[0] - before
    stop.set()
    counter.join()
    assert during > 3, during


def test_progress_is_watched_without_asking_python(heavy) -> None:
    progress = _core.Progress()
    result = lo.offset_face(heavy, DISTANCE, 1e-5, progress=progress)
    assert result.report.status == "ok" and progress.fraction == 1.0 and not progress.cancelled


def test_watched_progress_cancels_from_another_thread(heavy) -> None:
    progress = _core.Progress()
    timer = threading.Timer(0.02, progress.cancel)
    timer.start()
    with pytest.raises(lo.OffsetError) as refusal:
        lo.offset_face(heavy, DISTANCE, TIGHT, progress=progress)
    timer.join()
    assert refusal.value.status == "cancelled" and progress.cancelled


def test_parts_of_a_watched_progress_share_it() -> None:
    whole = _core.Progress()
    part = whole.part(1, 4).part(1, 2)
    assert part(0.5) is True and whole.fraction == pytest.approx(0.25 + 0.125 + 0.0625)
    assert part(7.0) and whole.fraction == pytest.approx(0.5)
    whole.cancel()
    assert part(0.0) is False and part.cancelled
    for index, count in ((-1, 2), (2, 2), (0, 0)):
        with pytest.raises(ValueError, match="index"):
            whole.part(index, count)


def test_engine_that_steps_back_gives_the_same() -> None:
    base = sample_shapes.trimmed_bspline_face()
    expected = lo.offset_face(base, 2.0).face.exportBrepToString()
    told: List[object] = []

    def behind() -> None:
        _core.set_engine_niceness(5)
        told.append(lo.offset_face(base, 2.0).face.exportBrepToString() == expected)
        told.append(lo.nearest_point(base, [(1.0, 2.0, 3.0)]).distance.shape)
        fractions: List[float] = []
        lo.offset_face(base, 2.0, progress=fractions.append)
        told.append(fractions[-1])
        try:
            lo.offset_face(base, 1e9)
        except lo.OffsetError as error:
            told.append(error.status)

    thread = threading.Thread(target=behind)
    thread.start()
    thread.join()
    assert told == [True, (1,), 1.0, "curvature-limit"], told
    with pytest.raises(ValueError, match="0 to 19"):
        _core.set_engine_niceness(20)
