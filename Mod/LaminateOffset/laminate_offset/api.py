# SPDX-License-Identifier: LGPL-2.1-or-later
"""The functions for users. Lengths are in mm; distances are signed along the face's outward normal."""

from dataclasses import dataclass
from typing import Any, Callable, Optional, Union

import FreeCAD
import Part

from . import _core
from .report import OffsetReport

Progress = Callable[[float], Optional[bool]]
Length = Union[float, "FreeCAD.Units.Quantity"]


@dataclass(frozen=True)
class OffsetResult:
    """A finished offset.

    Attributes:
        face: the new Part.Face, with the loops, the orientation and the edge order of the base.
        report: the OffsetReport; its status is "ok".
    """

    face: "Part.Face"
    report: OffsetReport


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
        OffsetResult with .face (a true B-spline or an exact analytic surface) and .report.

    Raises:
        OffsetError: the face was refused; says why, where on the face, and which distances in mm would work.
        ValueError: an argument is out of its range or has the wrong unit.
        TypeError: face is not a Part shape.
    """
    new_face, report = _core.offset_face(
        face,
        _millimetres(distance, "distance"),
        _millimetres(tolerance, "tolerance"),
        method,
        _millimetres(extension, "extension"),
        max_degree,
        progress,
    )
    return OffsetResult(new_face, OffsetReport(report))


def _millimetres(length: Any, name: str) -> float:
    if not isinstance(length, FreeCAD.Units.Quantity):
        if isinstance(length, (str, bytes)):
            raise TypeError(f"{name} must be a number in mm or a FreeCAD length, not the text {length!r}.")
        return float(length)
    if length.Unit != FreeCAD.Units.Length:
        raise ValueError(f"{name} must be a length; {length.UserString} is none. Give it in mm.")
    return float(length.Value)  # FreeCAD's internal unit of length is the millimetre
