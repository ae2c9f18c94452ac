# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks in which plies cover parts of the face."""

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import Any, Dict, Optional, Sequence, Tuple

import numpy
import Part

from . import _core
from .api import Progress
from .boundaries import Boundary
from .errors import OffsetError
from .layup import Layup, PhysicalPly
from .mass_properties import MassProperties, measure_partial
from .report import OffsetReport
from .stack import MaterialSolid, PlyStack, StackPly, stack_report

SIGNS = {"normal": 1.0, "reversed": -1.0}
# Volumes that agree to this part count as equal: OpenCASCADE finds those above ramps no better.
SAME_VOLUME = 2e-3
# Part of a ply's own volume that is not missed either, however large the body is that the ply is joined to.
LOST_PART = 0.25
# mm
INSIDE = 1e-6
# Places of a ply among which one inside of it is looked for, in each direction.
GRID = 31
# That a warning names; of more the first ones and the last one.
MOST_NAMES = 8


@dataclass(frozen=True)
class PartialStackPly(StackPly):
    """A StackPly of a stack in which plies cover parts of the face; its levels are measured on its own surfaces.

    Attributes:
        whole_face: the lay-up face.
        layer: the compiled part's LaidLayer: where it lies over base_face.
    """

    whole_face: Any = None
    layer: Any = None

    def heights(self, uv: Any) -> "Tuple[numpy.ndarray[Any, Any], numpy.ndarray[Any, Any]]":
        """The signed distances in mm of the surfaces of bottom and top from the lay-up face at parameters (n, 2), as two
        arrays (n,), whether the ply is there or not."""
        places = numpy.asarray(uv, dtype=float)
        feet, normals, _ = _core.evaluate_face(self.whole_face, places)
        sides = [_points(face, places) for face in (self.bottom_face, self.top_face)]
        bottom, top = (((side - feet) * normals).sum(axis=1) for side in sides)
        return bottom, top


def _points(face: "Part.Face", uv: Any) -> Any:
    """The points at parameters (n, 2), also where the surface has none of its normals, as at the pole of a sphere."""
    try:
        return _core.evaluate_face(face, uv)[0]
    except OffsetError:
        return numpy.array([tuple(face.valueAt(u, v)) for u, v in uv])


class PartialPlyStack(PlyStack):
    """A PlyStack in which plies cover parts of the face. Volumes and masses are those of the plies; pockets of resin do not
    count."""

    def material_solids(self) -> Tuple[MaterialSolid, ...]:
        """Neighbouring plies of one material that cover the same part of the face as one solid each, from the tool
        outwards. Raises as ply_solids does."""
        runs = [tuple(run) for _, run in groupby(self.plies, key=lambda ply: (ply.ply.ply.material, id(ply.base_face)))]
        solids = self._solids([(run[0], run[-1]) for run in runs])
        return tuple(MaterialSolid(run[0].ply.ply.material, run, solid) for run, solid in zip(runs, solids))

    def laminate_solid(self) -> "Part.Solid":
        """The laminate as one solid: from the first to the last ply of the whole face with the pockets of resin between,
        joined with the plies below and above these, beside which pockets stay open. Where all plies cover the same part, it
        lies between the first ply's bottom and the last one's top.

        Raises:
            ValueError: plies cover different parts, and none the whole face.
            OffsetError: a solid cannot be made, see ply_solids, or the solids cannot be joined.
        """
        whole = [index for index, ply in enumerate(self.plies) if not ply.ply.ply.boundary]
        if all(ply.base_face is self.plies[0].base_face for ply in self.plies):
            whole = [0, len(self.plies) - 1]
        if not whole:
            raise ValueError(
                "No ply covers the whole face, so the plies need not hang together in one solid; take ply_solids() or "
                "material_solids()."
            )
        below, above = self.plies[: whole[0]], self.plies[whole[-1] + 1 :]
        (body,) = self._solids([(self.plies[whole[0]], self.plies[whole[-1]])])
        for ply in (*below[::-1], *above):
            body = joined(body, ply)
        return body

    @cached_property
    def _mass_properties(self) -> MassProperties:
        return measure_partial(self.layup, [(ply.ply, ply.base_face, ply.layer) for ply in self.plies])

    def _solids(self, runs: Sequence[Tuple[StackPly, StackPly]]) -> "Tuple[Part.Solid, ...]":
        low_first = self.layup.direction == "normal"
        solids = []
        for first, last in runs:
            faces = [first.bottom_face, last.top_face] if low_first else [last.top_face, first.bottom_face]
            solids += _core.ply_solids(faces, [(0, 1)])
        return tuple(solids)


def joined(body: "Part.Solid", ply: StackPly) -> "Part.Solid":
    """A solid with the ply that lies on it, as one. Raises OffsetError where they do not make one valid solid."""
    name = ply.ply.name
    try:
        solids = body.fuse(ply.solid).Solids
    except Part.OCCError as error:
        raise OffsetError(
            "kernel-error", "topology", f"Ply {name} could not be joined to the others: {error}"
        ) from error
    expected = body.Volume + ply.solid.Volume
    good = len(solids) == 1 and solids[0].isValid() and solids[0].isClosed()
    error = abs(solids[0].Volume - expected) if good else expected
    if error > min(SAME_VOLUME * expected, LOST_PART * ply.solid.Volume) or not _holds(solids[0], ply):
        raise OffsetError(
            "invalid-result",
            "topology",
            f"Ply {name} could not be joined to the others in one valid solid; take ply_solids() or material_solids().",
        )
    return solids[0]


def _holds(solid: "Part.Solid", ply: StackPly) -> bool:
    """Whether a place half way through the ply is inside of the solid."""
    u0, u1, v0, v1 = ply.base_face.ParameterRange
    steps = (numpy.arange(GRID) + 0.5) / GRID
    for u, v in ((u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a in steps for b in steps):
        if ply.base_face.isPartOfDomain(u, v):
            low, high = (face.Surface.value(u, v) for face in (ply.bottom_face, ply.top_face))
            return bool(solid.isInside((low + high) * 0.5, INSIDE, False))
    return True


@dataclass(frozen=True)
class Laying:
    """How plies are laid. Tolerance and boundary_gap in mm; drop_off as drop_off_of gives it; insets: one for every ply,
    in mm."""

    tolerance: float
    max_degree: Optional[int]
    surface: str
    drop_off: Tuple[float, Optional[float]]
    insets: Sequence[float]
    ramp_slope: str
    boundary_gap: Optional[float]
    progress: Optional[Progress]


def lay_partial_plies(
    face: Any, layup: Layup, plies: Sequence[PhysicalPly], boundaries: Dict[str, Boundary], how: Laying
) -> PartialPlyStack:
    """The stack of plies of which some have boundaries."""
    names = list(boundaries)
    ratio, ramp_length = how.drop_off
    moved, made, gaps, inset_error, steep, elapsed = _core.stack_plies(
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
        ramp_slope=how.ramp_slope,
        boundary_gap=how.boundary_gap,
        middle=how.surface == "middle",
        progress=how.progress,
    )
    whole = face if moved is None else moved
    stacked = []
    reports = []
    for ply, (region, bottom, middle, top, layer, slopes) in zip(plies, made):
        shape, report, over_ramp = {"bottom": bottom, "middle": middle, "top": top}[how.surface]
        reports += [OffsetReport(one[1]) for one in (bottom, middle, top) if one]
        own = (ply, bottom[0], top[0], shape, OffsetReport(report), region, over_ramp, slopes)
        stacked.append(PartialStackPly(*own, whole_face=whole, layer=layer))
    report = stack_report(layup, plies, reports, False, elapsed)
    report["boundary_gaps"] = {name: gap for name, gap in zip(names, gaps) if gap is not None}
    report["inset_error"] = inset_error
    report["seam_moved"] = moved is not None
    for place in steep:
        ending = [plies[index] for index in place["plies"]]
        place["plies"] = [ply.name for ply in ending]
        place["boundaries"] = list(dict.fromkeys(ply.ply.boundary for ply in ending))
        report["warnings"].append(_steep_ramps_text(place))
    report["steep_ramps"] = steep
    return PartialPlyStack(layup, stacked, report, whole)


def _steep_ramps_text(steep: Dict[str, Any]) -> str:
    place = ", ".join(plain(steep["where"][axis], 6) for axis in "xyz")
    step = plain_up(steep["longest"])
    boundaries = [f"'{name}'" for name in steep["boundaries"]]
    if len(boundaries) == 1:
        what = "end along one line or nearly so"
        remedy = f"Let their edges lie {step} mm apart with a stagger (0, {step}, ...) of the boundary {boundaries[0]}"
    else:
        what = "end near each other"
        own = ", and so the plies of each" if len(steep["plies"]) > len(boundaries) else ""
        remedy = f"Keep the boundaries {_listed(boundaries)} {step} mm apart{own}"
    return (
        f"Plies {_listed(steep['plies'])} {what}: near ({place}) mm the plies above come down by 1:{plain(1.0 / steep['slope'])}, "
        f"{plain(steep['slope'] / steep['alone'])} times as steeply as beside one of them. {remedy}."
    )


def _listed(names: Sequence[str]) -> str:
    if len(names) > MOST_NAMES:
        return f"{', '.join(names[: MOST_NAMES - 2])}, ... and {names[-1]} ({len(names)} in all)"
    *others, last = names
    return f"{', '.join(others)} and {last}"


def plain(value: float, digits: int = 3) -> str:
    """A number with so many digits that count, or fewer, down to millionths and never with an exponent."""
    first = math.floor(math.log10(max(abs(value), 1e-6)))
    text = f"{value:.{min(6, max(0, digits - 1 - first))}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def plain_up(length: float) -> str:
    """A length in mm rounded up to two digits."""
    unit = 10.0 ** (math.floor(math.log10(length)) - 1)
    return plain(math.ceil(length / unit - 1e-6) * unit, 2 if length < 1e2 else 6)
