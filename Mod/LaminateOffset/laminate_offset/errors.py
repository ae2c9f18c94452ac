# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one exception for a face that could not be offset."""

from typing import Any, Dict, Optional, Tuple

from .report import OffsetReport

Where = Dict[str, float]
FeasibleRange = Tuple[Optional[float], Optional[float]]


class OffsetError(RuntimeError):
    """A refusal: what was decided, where in the pipeline, where on the face, and what would work.

    Attributes:
        status: the reason's stable name, e.g. "curvature-limit".
        stage: the stage which refused, e.g. "analysis".
        message: one or two sentences that name the thing and the remedy.
        where: the place on the base face as {"u", "v", "x", "y", "z"} (x, y, z in mm), or None.
        feasible_range: (most negative, largest positive) distance in mm, signed along the face's outward normal, that
            would work; a side without a limit is None. None as a whole when it is not known.
        report: the refusal's OffsetReport.
    """

    def __init__(
        self,
        status: str,
        stage: str,
        message: str,
        where: Optional[Where] = None,
        feasible_range: Optional[FeasibleRange] = None,
        report: Optional[Dict[str, Any]] = None,
    ) -> None:
        super().__init__(status, stage, message, where, feasible_range, report)
        self.status = status
        self.stage = stage
        self.message = message
        self.where = where
        self.feasible_range = feasible_range
        self.report = OffsetReport(report or _bare_report(status, stage, message, where))

    def __str__(self) -> str:
        text = f"{self.status}: {self.message}"
        if self.where is not None:
            text += " At u={u:.6g}, v={v:.6g}; x={x:.6g}, y={y:.6g}, z={z:.6g} mm.".format(**self.where)
        if self.feasible_range is not None:
            text += f" Feasible distances: {describe_range(self.feasible_range)}."
        return text


def describe_range(feasible_range: FeasibleRange) -> str:
    """The range of signed distances in words, e.g. "from -12.5 mm up to any positive one"."""
    negative, positive = feasible_range
    lower = "any negative one" if negative is None else f"{negative:.6g} mm"
    upper = "any positive one" if positive is None else f"{positive:.6g} mm"
    return f"from {lower} up to {upper}"


def _bare_report(status: str, stage: str, message: str, where: Optional[Where]) -> Dict[str, Any]:
    return {"status": status, "stage": stage, "message": message, "where": where}
