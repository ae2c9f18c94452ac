# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks in which plies cover parts of the face."""

from dataclasses import dataclass
from typing import Any, Dict, Optional, Sequence, Tuple

import numpy
import Part

from . import _core
from .api import Progress
from .boundaries import Boundary
from .layup import Layup, PhysicalPly
from .mass_properties import MassProperties
from .report import OffsetReport
from .stack import PlyStack, StackPly, stack_report

SIGNS = {"normal": 1.0, "reversed": -1.0}


@dataclass(frozen=True)
class PartialStackPly(StackPly):
    """A StackPly of a stack in which plies cover parts of the face; its levels are measured on its own surfaces."""

    whole_face: Any = None

    def heights(self, uv: Any) -> "Tuple[numpy.ndarray[Any, Any], numpy.ndarray[Any, Any]]":
        """The signed distances in mm of the surfaces of bottom and top from the lay-up face at parameters (n, 2), as two
        arrays (n,), whether the ply is there or not."""
        places = numpy.asarray(uv, dtype=float)
        feet, normals, _ = _core.evaluate_face(self.whole_face, places)
        sides = [_core.evaluate_face(face, places)[0] for face in (self.bottom_face, self.top_face)]
        bottom, top = (((side - feet) * normals).sum(axis=1) for side in sides)
        return bottom, top


class PartialPlyStack(PlyStack):
    """A PlyStack in which plies cover parts of the face. Every ply has its own solid; solids of several plies and mass
    properties are not made, since what lies between them is not the same everywhere."""

    def mass_properties(self) -> MassProperties:
        """Not made for plies with boundaries: raises ValueError."""
        raise ValueError("Mass properties of stacks with boundaries are not computed; take plies without boundaries.")

    def _solids(self, runs: Sequence[Tuple[StackPly, StackPly]]) -> "Tuple[Part.Solid, ...]":
        if any(first is not last for first, last in runs):
            raise ValueError("Plies with boundaries have no common solid; take the solid of every ply.")
        low_first = self.layup.direction == "normal"
        solids = []
        for ply, _ in runs:
            faces = [ply.bottom_face, ply.top_face] if low_first else [ply.top_face, ply.bottom_face]
            solids += _core.ply_solids(faces, [(0, 1)])
        return tuple(solids)


@dataclass(frozen=True)
class Laying:
    """How plies are laid. Tolerance in mm; drop_off as drop_off_of gives it; insets: one for every ply, in mm."""

    tolerance: float
    max_degree: Optional[int]
    surface: str
    drop_off: Tuple[float, Optional[float]]
    insets: Sequence[float]
    progress: Optional[Progress]


def lay_partial_plies(
    face: Any, layup: Layup, plies: Sequence[PhysicalPly], boundaries: Dict[str, Boundary], how: Laying
) -> PartialPlyStack:
    """The stack of plies of which some have boundaries."""
    names = list(boundaries)
    ratio, ramp_length = how.drop_off
    made, inset_error, elapsed = _core.stack_plies(
        face,
        [
            (ply.thickness, names.index(ply.ply.boundary) if ply.ply.boundary else None, inset)
            for ply, inset in zip(plies, how.insets)
        ],
        [boundaries[name].for_engine(name) for name in names],
        tolerance=how.tolerance,
        max_degree=how.max_degree,
        direction=SIGNS[layup.direction],
        start=plies[0].bottom,
        ratio=ratio,
        ramp_length=ramp_length,
        middle=how.surface == "middle",
        progress=how.progress,
    )
    stacked = []
    reports = []
    for ply, (region, bottom, middle, top) in zip(plies, made):
        shape, report, over_ramp = {"bottom": bottom, "middle": middle, "top": top}[how.surface]
        reports += [OffsetReport(one[1]) for one in (bottom, middle, top) if one]
        laid = PartialStackPly(ply, bottom[0], top[0], shape, OffsetReport(report), region, over_ramp, whole_face=face)
        stacked.append(laid)
    report = {**stack_report(layup, plies, reports, False, elapsed), "inset_error": inset_error}
    return PartialPlyStack(layup, stacked, report, face)
