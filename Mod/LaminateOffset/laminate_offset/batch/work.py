# SPDX-License-Identifier: LGPL-2.1-or-later
"""One job of a batch: from its files to its output and its record."""

import os
import time
from contextlib import suppress
from functools import lru_cache
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import Part

from .. import _core
from ..boundary_texts import boundaries_of, once, parse_drop_off, parse_side, parse_stagger
from ..each_face import FaceOutcome, OffsetRequest, choose, kernel_error, offset_each, refusal_line
from ..errors import OffsetError
from ..files import read_faces, write_shape
from ..layup import LayupError, read_layup
from ..replacing import FileError
from ..stack import stack_plies
from .records import DONE, FAILED, PARTLY, make_record, read_record, record_path, write_record

Made = Tuple[str, str, Any, Dict[str, Any]]


def carry_out(
    task: Mapping[str, Any], paths: Mapping[str, str], digests: Mapping[str, Optional[str]]
) -> Dict[str, Any]:
    """Does what a row asks for; writes output and record, and returns the record.

    A job that fails has a record but no output: an output that an earlier run of the same batch left is removed, since
    it would no longer be what the row asks for.

    Args:
        task: the row, see Job.task.
        paths: where "input", "layup" and "boundaries" (if any) and "output" are.
        digests: those of the files that are read.
    """
    start = time.monotonic()
    output = paths["output"]
    ours = read_record(output) is not None
    os.makedirs(os.path.dirname(output), exist_ok=True)
    # Without its record an output counts as not done, so a run that is killed from here on repeats the job.
    with suppress(FileNotFoundError):
        os.remove(record_path(output))
    try:
        make = _stack if task["layup"] else _offset
        state, reason, report, figures = make(task, paths, digests)
    except OffsetError as refusal:
        state, reason = FAILED, refusal_line(task["face"], refusal)
        report, figures = refusal.report.to_dict(), {}
    except (FileError, LayupError, ValueError, RuntimeError, MemoryError, OSError) as error:
        state, reason, report, figures = FAILED, str(error) or type(error).__name__, None, {}
    if state == FAILED and ours:
        with suppress(FileNotFoundError):
            os.remove(output)
    figures["elapsed_ms"] = 1e3 * (time.monotonic() - start)
    record = make_record(task, digests, state, reason, figures=figures, report=report)
    write_record(record, output)
    return record


def _offset(task: Mapping[str, Any], paths: Mapping[str, str], digests: Mapping[str, Optional[str]]) -> Made:
    chosen = choose(_faces(paths["input"], digests["input"]), task["face"], task["input"])
    outcomes = list(offset_each(chosen, OffsetRequest(task["distance"], _tolerance(task)), lambda _fraction: None))
    one = task["face"] is not None
    made = [outcome for outcome in outcomes if outcome.shape is not None]
    if made:
        shape = made[0].shape if one else Part.Compound([outcome.shape for outcome in made])
        write_shape(shape, paths["output"], f"Offset {task['distance']:g} mm")
    reports = [{"face": outcome.number, **outcome.report.to_dict()} for outcome in outcomes]
    state = DONE if len(made) == len(outcomes) else PARTLY if made else FAILED
    return state, _reasons(outcomes), reports[0] if one else reports, _figures([o.report for o in made], len(outcomes))


def _stack(task: Mapping[str, Any], paths: Mapping[str, str], digests: Mapping[str, Optional[str]]) -> Made:
    layup = read_layup(paths["layup"])
    ((_, face),) = choose(_faces(paths["input"], digests["input"]), task["face"], task["input"])
    try:
        stack = stack_plies(face, layup, _tolerance(task), **_bounding(task, paths))
    except OffsetError:
        raise
    except (RuntimeError, MemoryError) as error:
        raise kernel_error(error) from error
    stack.export(paths["output"])
    return DONE, "", {**stack.report, "stack": stack.ply_reports()}, _figures([stack.report], len(stack.plies))


def _bounding(task: Mapping[str, Any], paths: Mapping[str, str]) -> Dict[str, Any]:
    """What stack_plies takes for plies with boundaries; what the row does not say is left to it."""
    sides = [parse_side(entry) for entry in task.get("side", ())]
    options: Dict[str, Any] = {"boundaries": boundaries_of(paths.get("boundaries"), sides, "side")}
    if "drop_off" in task:
        options["drop_off"] = parse_drop_off(task["drop_off"])
    if "stagger" in task:
        options["stagger"] = once((parse_stagger(entry) for entry in task["stagger"]), "stagger")
    return {**options, **{name: task[name] for name in ("ramp_slope", "boundary_gap") if name in task}}


@lru_cache(maxsize=1)
def _faces(path: str, _digest: Optional[str]) -> List["Part.Face"]:
    """The faces of a file; neighbouring rows often name the same one."""
    return read_faces(path)


def _tolerance(task: Mapping[str, Any]) -> float:
    given = task["tolerance"]
    return float(_core.default_options()["tolerance"] if given is None else given)


def _reasons(outcomes: Sequence[FaceOutcome]) -> str:
    return "; ".join(outcome.reason for outcome in outcomes if outcome.reason)


def _figures(reports: Sequence[Mapping[str, Any]], count: int) -> Dict[str, Any]:
    """The figures of the summary: how many faces or plies, and the largest errors; None where one is not proven."""
    figures: Dict[str, Any] = {"count": count}
    for name in ("certified_error", "edge_error"):
        errors = [report[name] for report in reports]
        figures[name] = max(errors) if errors and None not in errors else None
    return figures
