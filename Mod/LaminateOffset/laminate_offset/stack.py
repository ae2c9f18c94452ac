# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ply stacks: the surfaces of all plies of a layup on one face, from one fit."""

import json
from dataclasses import dataclass, replace
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import Part

from . import _core
from .api import Length, Progress, millimetres
from .layup import Layup, LayupError, PhysicalPly
from .layup.errors import Problem
from .report import OffsetReport

SURFACES = ("bottom", "middle", "top")


@dataclass(frozen=True)
class StackPly:
    """One ply of a finished stack.

    Attributes:
        ply: what it is: number, name, row of the layup, thickness and signed distances, in mm.
        bottom_face: its side towards the tool.
        top_face: its side away from the tool; the next ply's bottom_face is the same surface.
        face: the surface that was asked for: the bottom, the middle or the top one.
        report: the OffsetReport of `face`.
    """

    ply: PhysicalPly
    bottom_face: "Part.Face"
    top_face: "Part.Face"
    face: "Part.Face"
    report: OffsetReport


class PlyStack:
    """The plies of a layup on a face.

    Attributes:
        layup: the layup, with the direction that was used.
        plies: the StackPlys, from the tool outwards.
        report: the figures of the whole stack as a dict: plies, thickness, tolerance, the largest certified_error and
            edge_error (None where one is not proven), one_fit (all surfaces are members of one family, with the same
            knots and trimming curves) and elapsed_ms.
    """

    def __init__(self, layup: Layup, plies: Sequence[StackPly], report: Dict[str, Any]) -> None:
        self.layup = layup
        self.plies: Tuple[StackPly, ...] = tuple(plies)
        self.report = report

    @property
    def bottom_face(self) -> "Part.Face":
        """The first ply's side towards the tool."""
        return self.plies[0].bottom_face

    @property
    def top_face(self) -> "Part.Face":
        """The last ply's side away from the tool."""
        return self.plies[-1].top_face

    def to_shape(self) -> "Part.Compound":
        """A compound of the plies' faces, from the tool outwards."""
        return Part.makeCompound([ply.face for ply in self.plies])

    def summary(self) -> str:
        """One line for a person: plies, thickness and the proven error."""
        error = self.report["certified_error"]
        proven = "not proven" if error is None else f"proven within {error:.2g} mm"
        return f"{len(self.plies)} plies, {self.report['thickness']:g} mm, {proven}"

    def to_json(self) -> str:
        """The stack's report with one entry for every ply, as indented JSON text."""
        return json.dumps({**self.report, "stack": self.ply_reports()}, indent=2, ensure_ascii=False)

    def ply_reports(self) -> List[Dict[str, Any]]:
        """For every ply its number, name, material, angle, thickness and distances, and its surface's report."""
        return [
            {
                "number": ply.ply.number,
                "name": ply.ply.name,
                "material": ply.ply.ply.material,
                "angle": ply.ply.ply.angle,
                "thickness": ply.ply.thickness,
                "bottom": ply.ply.bottom,
                "middle": ply.ply.middle,
                "top": ply.ply.top,
                "report": ply.report.to_dict(),
            }
            for ply in self.plies
        ]


def stack_plies(
    face: "Part.Face",
    layup: Union[Layup, str],
    tolerance: Length = 1e-3,
    direction: Optional[str] = None,
    surface: str = "top",
    max_degree: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> PlyStack:
    """Lay the plies of a layup on a trimmed face.

    All surfaces come from one analysis and one fit whose error is proven for every distance of the stack, so that many
    plies cost little more than one. Neighbours share their surface: no gap, no overlap.

    Args:
        face: the lay-up surface, a Part.Face. Its orientation and placement count.
        layup: a Layup, or the path of a layup table or document.
        tolerance: largest deviation of every surface from the exact offset in mm, or a FreeCAD length; above zero.
        direction: "normal" stacks along the face's outward normal, "reversed" against it; None: the layup's own.
        surface: which surface of every ply is its .face: "bottom" (towards the tool), "middle" or "top".
        max_degree: highest degree of the fitted surfaces, from 3 to 7; None leaves the choice to the engine.
        progress: called from time to time with a fraction from 0 to 1; returning False cancels.

    Returns:
        PlyStack with .plies[i].face and .report, .top_face, .report, .to_shape().

    Raises:
        LayupError: the layup is wrong, has no active ply, or a ply has a boundary: plies here cover the whole face.
        OffsetError: a distance of the stack was refused; says which, why, where, and what would work.
        ValueError: an argument is out of its range.
    """
    if surface not in SURFACES:
        raise ValueError(f"surface must be one of {', '.join(SURFACES)}; it is {surface!r}.")
    layup = _directed(_read(layup), direction)
    plies = _whole_plies(layup)
    levels, distances = _levels(plies, surface)
    made, one_fit, elapsed = _core.offset_stack(
        face, distances, millimetres(tolerance, "tolerance"), max_degree, progress
    )
    surfaces = {distance: (shape, OffsetReport(report)) for distance, (shape, report) in zip(distances, made)}
    stacked = [
        StackPly(ply, surfaces[ply.bottom][0], surfaces[ply.top][0], *surfaces[level])
        for ply, level in zip(plies, levels)
    ]
    return PlyStack(
        layup, stacked, _stack_report(layup, plies, [report for _, report in surfaces.values()], one_fit, elapsed)
    )


def _read(layup: Union[Layup, str]) -> Layup:
    if isinstance(layup, Layup):
        return layup
    from .layup import read_layup

    return read_layup(layup)


def _directed(layup: Layup, direction: Optional[str]) -> Layup:
    return layup if direction is None else replace(layup, direction=direction)


def _whole_plies(layup: Layup) -> Tuple[PhysicalPly, ...]:
    """The physical plies; refuses those that do not cover the whole face."""
    plies = layup.physical_plies()
    problems = [] if plies else [Problem("active", "no ply", "at least one active ply", unit="layup")]
    for row, ply in enumerate(layup.plies, start=1):
        if ply.active and ply.boundary:
            expected = "nothing: plies are laid on the whole face; trim the face, or leave the boundary out"
            problems.append(Problem("boundary", repr(ply.boundary), expected, row, "ply"))
        if ply.active and ply.limits:
            expected = "no grid limits: plies are laid on the whole face"
            problems.append(Problem("limits", repr(dict(ply.limits)), expected, row, "ply"))
    if problems:
        raise LayupError("layup", problems)
    return plies


def _levels(plies: Sequence[PhysicalPly], surface: str) -> Tuple[List[float], List[float]]:
    """The distance of every ply's own surface, and all distances that are needed, each once."""
    levels = [getattr(ply, surface) for ply in plies]
    needed = [distance for ply in plies for distance in (ply.bottom, ply.top)] + levels
    return levels, list(dict.fromkeys(needed))


def _stack_report(
    layup: Layup, plies: Sequence[PhysicalPly], reports: Sequence[OffsetReport], one_fit: bool, elapsed: float
) -> Dict[str, Any]:
    return {
        "status": "ok",
        "plies": len(plies),
        "thickness": layup.thickness,
        "direction": layup.direction,
        "reference": layup.reference,
        "tolerance": reports[0].tolerance,
        "certified_error": _largest([report.certified_error for report in reports]),
        "edge_error": _largest([report.edge_error for report in reports]),
        "one_fit": one_fit,
        "elapsed_ms": elapsed,
    }


def _largest(errors: Sequence[Optional[float]]) -> Optional[float]:
    proven = [error for error in errors if error is not None]
    return max(proven) if len(proven) == len(errors) else None
