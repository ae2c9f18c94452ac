# SPDX-License-Identifier: LGPL-2.1-or-later
"""The functions for users. Lengths are in mm; distances are signed along the face's outward normal."""

import copy
import json
from dataclasses import dataclass
from typing import Any, Callable, Dict, Mapping, Optional, Union

import FreeCAD
import Part

from . import _core
from .errors import describe_range
from .report import OffsetReport

Progress = Callable[[float], Optional[bool]]
Length = Union[float, "FreeCAD.Units.Quantity"]


@dataclass(frozen=True)
class OffsetResult:
    """A finished offset.

    Attributes:
        shape: the new Part.Face, with the loops, the orientation and the edge order of the base. Where creases tear
            the offset, a Part.Shell of one face for each part of the base between them; its faces are valid and do
            not share edges along the creases, which report.gap and report.crease describe.
        report: the OffsetReport; its status is "ok".
    """

    shape: "Union[Part.Face, Part.Shell]"
    report: OffsetReport

    @property
    def face(self) -> "Union[Part.Face, Part.Shell]":
        """The same object as shape: a Part.Face, or a Part.Shell where the base is creased."""
        return self.shape


class OffsetLimits:
    """The distances by which a face can be offset before its offset folds, and where it would fold first.

    Attributes:
        negative: most negative feasible distance in mm along the face's outward normal, zero or less; None: no limit.
        positive: largest feasible distance in mm, zero or more; None: no limit.
        where_negative: the place that folds first on the negative side, {"u", "v", "x", "y", "z"} (x, y, z in mm), or
            None.
        where_positive: the same for the positive side.
        proven: whether the limits are proven; False where curvature could only be sampled, at poles and on
            swept offset curves.
    """

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values: Dict[str, Any] = copy.deepcopy(dict(values))
        self.negative: Optional[float] = self._side("negative", "distance")
        self.positive: Optional[float] = self._side("positive", "distance")
        self.where_negative: Optional[Dict[str, float]] = self._side("negative", "where")
        self.where_positive: Optional[Dict[str, float]] = self._side("positive", "where")
        self.proven: bool = self._values["proven"]

    def _side(self, side: str, key: str) -> Any:
        limit = self._values[side]
        return None if limit is None else copy.deepcopy(limit[key])

    def to_dict(self) -> Dict[str, Any]:
        """The documented form: status, stage, message, where, proven, negative and positive; a copy.

        negative and positive are {"distance", "where"}, or None for a side without a limit.
        """
        return copy.deepcopy(self._values)

    def to_json(self) -> str:
        """The same as indented JSON text."""
        return json.dumps(self._values, indent=2, ensure_ascii=False)

    def summary(self) -> str:
        """One line for a person: the feasible distances."""
        known = "" if self.proven else " (sampled, not proven)"
        return f"feasible distances {describe_range((self.negative, self.positive))}{known}"

    def __repr__(self) -> str:
        return f"OffsetLimits(negative={self.negative!r}, positive={self.positive!r}, proven={self.proven!r})"


def offset_limits(face: "Part.Face") -> OffsetLimits:
    """Find the distances by which a trimmed face can be offset before its offset folds.

    Only the part inside the trimming loops counts. The limits follow from curvature; whether distant parts of an
    offset meet each other is found out by offset_face for its one distance.

    Args:
        face: a Part.Face. Its orientation and placement count, as for offset_face.

    Returns:
        OffsetLimits with .negative and .positive in mm along the face's outward normal.

    Raises:
        OffsetError: the face was refused; it says why and where.
        TypeError: face is not a Part shape.
    """
    return OffsetLimits(json.loads(_core.offset_limits(face)))


def offset_face(
    face: "Part.Face",
    distance: Length,
    tolerance: Length = 1e-3,
    method: str = "same-parameter",
    extension: Length = 0.0,
    max_degree: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> OffsetResult:
    """Offset a trimmed face by a constant distance along its outward normal.

    The base face is only read. Other Python threads keep running during the computation, and Ctrl-C stops it.

    Args:
        face: a Part.Face. Its orientation and placement count: the outward normal is what face.normalAt(u, v) gives,
            and reversing the face turns the sign of the distance.
        distance: signed distance in mm, or a FreeCAD length; positive is outward, negative is inward.
        tolerance: largest deviation of the result from the exact offset in mm, or a FreeCAD length; above zero.
        method: "same-parameter" (keeps the base's parametrisation and trimming curves) or "ravi-kumar".
        extension: length in mm, or a FreeCAD length, by which the result is extended past the edges; zero or more.
        max_degree: highest degree of the fitted surface, from 3 to 7; None leaves the choice to the engine.
        progress: called from time to time with a fraction from 0 to 1; returning False cancels. What it raises ends
            the computation and is raised again here.

    Returns:
        OffsetResult with .face (a true B-spline or an exact analytic surface; .shape is the same object) and .report.
        Where the base has creases, that is a Part.Shell with a face for each part between them.

    Raises:
        OffsetError: the face was refused; says why, where on the face, and which distances in mm would work.
        ValueError: an argument is out of its range or has the wrong unit.
        TypeError: face is not a Part shape.
    """
    shape, report = _core.offset_face(
        face,
        _millimetres(distance, "distance"),
        _millimetres(tolerance, "tolerance"),
        method,
        _millimetres(extension, "extension"),
        max_degree,
        progress,
    )
    return OffsetResult(shape, OffsetReport(report))


def _millimetres(length: Any, name: str) -> float:
    if not isinstance(length, FreeCAD.Units.Quantity):
        if isinstance(length, (str, bytes)):
            raise TypeError(f"{name} must be a number in mm or a FreeCAD length, not the text {length!r}.")
        return float(length)
    if length.Unit != FreeCAD.Units.Length:
        raise ValueError(f"{name} must be a length; {length.UserString} is none. Give it in mm.")
    return float(length.Value)  # FreeCAD's internal unit of length is the millimetre
