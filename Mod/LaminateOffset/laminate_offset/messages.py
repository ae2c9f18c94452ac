# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wording of outcomes for the user: refusals, figures and limits as short plain sentences.

Lengths are in millimetres throughout.
"""

import math
from typing import Any, Mapping, Optional, Tuple

from .errors import describe_range


def number(value: Optional[float], unit: str = "mm") -> str:
    """A figure with four significant digits and its unit, or "not available" for None and NaN."""
    if value is None or math.isnan(value):
        return "not available"
    return f"{value:.4g} {unit}".rstrip()


def feasible_range(limits: Any) -> str:
    """The distances that would work, e.g. "from -9.5 mm up to any positive one"; "" when they are not known."""
    pair = _pair(limits)
    return "" if pair is None else describe_range(pair)


def place(where: Any) -> str:
    """The place on the base face, e.g. "(12, 0, 3.5) mm"; "" when there is none."""
    if not where:
        return ""
    # Rounding to 1e-6 mm keeps 6e-17 from being shown where zero is meant; adding 0.0 turns -0.0 into 0.0.
    return "({:.7g}, {:.7g}, {:.7g}) mm".format(*(round(_entry(where, axis), 6) + 0.0 for axis in "xyz"))


def refusal(error: Exception, face: str = "") -> str:
    """What was refused, why, where and what would work, from an OffsetError or any other error.

    face names the sub-element, e.g. "Face3".
    """
    text = str(getattr(error, "message", "") or error).strip()
    if face:
        text = f"{face}: {text}"
    spot = place(getattr(error, "where", None))
    if spot:
        text += f" Place: {spot}."
    feasible = feasible_range(getattr(error, "feasible_range", None))
    if feasible:
        text += f" Feasible distances: {feasible}."
    return text


def summary(report: Mapping[str, Any]) -> str:
    """One line on one finished offset face, from its report."""
    surface = report["surface"]
    parts = [surface_type(surface)]
    if report.get("faces", 1) > 1:
        parts.append(f"{report['faces']} faces along creases{_tear(report)}")
    for title, key in (("proven error", "certified_error"), ("sampled error", "sampled_error")):
        if report.get(key) is not None:
            parts.append(f"{title} {number(report[key])}")
            break
    if report.get("edge_error") is not None:
        parts.append(f"edge error {number(report['edge_error'])}")
    feasible = feasible_range(report.get("limits"))
    if feasible:
        parts.append(f"feasible {feasible}")
    return ", ".join(parts)


def _tear(report: Mapping[str, Any]) -> str:
    return "" if report.get("gap") is None else f", torn by up to {number(report['gap'])}"


def surface_type(surface: Mapping[str, Any]) -> str:
    """E.g. "exact cylinder" or "B-spline of degree 5 x 4 with 12 x 8 = 96 poles"."""
    if surface["type"] != "bspline":
        return f"exact {surface['type']}"
    poles_u, poles_v = surface["poles_u"], surface["poles_v"]
    kind = "rational B-spline" if surface["rational"] else "B-spline"
    degree = f"{surface['degree_u']} x {surface['degree_v']}"
    return f"{kind} of degree {degree} with {poles_u} x {poles_v} = {poles_u * poles_v} poles"


def _pair(limits: Any) -> Optional[Tuple[Optional[float], Optional[float]]]:
    """(negative, positive) from a report's mapping or an error's tuple; None when unknown."""
    if limits is None:
        return None
    if isinstance(limits, Mapping):
        return limits.get("negative"), limits.get("positive")
    low, high = limits
    return low, high


def _entry(where: Any, axis: str) -> float:
    return where[axis] if isinstance(where, Mapping) else getattr(where, axis)
