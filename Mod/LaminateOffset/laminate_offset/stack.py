# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ply stacks: the surfaces, solids and figures of all plies of a layup on one face, from one fit."""

import json
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby
from numbers import Integral
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import FreeCAD
import numpy
import Part

from . import _core
from .api import Length, Progress, millimetres
from .boundaries import Boundaries, Stagger, check_names, drop_off_of, gap_of, insets, named_boundaries
from .core_sample import CoreSample, core_samples, covered, line_points, stack_thickness
from .layup import Layup, LayupError, PhysicalPly
from .layup.errors import Problem
from .mass_properties import MassProperties, PlyProperties, measure
from .report import OffsetReport
from .rosette import Rosettes, fibre_directions, rosette_of

SURFACES = ("bottom", "middle", "top")
RAMP_SLOPES = ("mean", "steepest")


@dataclass(frozen=True)
class StackPly:
    """One ply of a finished stack.

    Attributes:
        ply: what it is: number, name, row of the layup, thickness and signed distances, in mm.
        bottom_face: its side towards the tool.
        top_face: its side away from the tool; the next ply's bottom_face is the same surface.
        face: the surface that was asked for: the bottom, the middle or the top one.
        report: the OffsetReport of `face`.
        base_face: the part of the lay-up face that the ply covers.
        over_ramp: whether `face` comes down over ramps of plies below; its distance from the lay-up face then varies,
            and the one in the report is that where every ply below is present.
        ramp: how the plies above come down beside it, or None where none does: length in mm; start_slope and end_slope (0:
            the ramp is level there), mean_slope and steepest_slope, heights over lengths along the face.
    """

    ply: PhysicalPly
    bottom_face: "Part.Face"
    top_face: "Part.Face"
    face: "Part.Face"
    report: OffsetReport
    base_face: "Part.Face"
    over_ramp: bool = False
    ramp: Optional[Dict[str, float]] = None
    _stack: "Optional[PlyStack]" = field(default=None, repr=False, compare=False)

    @property
    def solid(self) -> "Part.Shape":
        """The ply as a valid, closed solid; on a face with creases a Part.Compound with a solid for each part. Neighbours'
        solids share the face between them only where no ply of the stack has a boundary. Made when first asked for, those
        of all plies at once. Raises OffsetError as PlyStack.ply_solids does."""
        return self._owner().ply_solids()[self.ply.number - 1]

    @property
    def properties(self) -> PlyProperties:
        """Area, volume, mass and centre of gravity; see PlyProperties."""
        return self._owner().mass_properties().plies[self.ply.number - 1]

    @property
    def area(self) -> float:
        """Of the ply's true middle surface, in mm2."""
        return self.properties.area

    @property
    def volume(self) -> float:
        """Between bottom and top, in mm3."""
        return self.properties.volume

    @property
    def mass(self) -> Optional[float]:
        """In kg; None where neither density nor areal weight of the material is known."""
        return self.properties.mass

    @property
    def center(self) -> "FreeCAD.Vector":
        """Centre of gravity, in mm."""
        return self.properties.center

    def levels(self, uv: Any) -> "Tuple[numpy.ndarray[Any, Any], numpy.ndarray[Any, Any]]":
        """The signed distances in mm of bottom and top from the lay-up face at parameters (n, 2), as two arrays (n,);
        NaN where the ply is not. It is there on its edges, too."""
        places = numpy.asarray(uv, dtype=float)
        there = covered(self.base_face, places)
        bottom, top = (numpy.where(there, side, numpy.nan) for side in self.heights(places))
        return bottom, top

    def heights(self, uv: Any) -> "Tuple[numpy.ndarray[Any, Any], numpy.ndarray[Any, Any]]":
        """As levels, but of the surfaces of bottom and top, whether the ply is there or not."""
        count = len(uv)
        return numpy.full(count, self.ply.bottom), numpy.full(count, self.ply.top)

    def _owner(self) -> "PlyStack":
        if self._stack is None:
            raise ValueError("This ply belongs to no stack; take it from the .plies of a PlyStack.")
        return self._stack


@dataclass(frozen=True)
class MaterialSolid:
    """Plies of one material that follow each other, as one solid.

    Attributes:
        material: its name.
        plies: the StackPlys, from the tool outwards.
        solid: a Part.Solid, from the first ply's bottom to the last ply's top; on a face with creases a Part.Compound with
            one for each part.
    """

    material: str
    plies: Tuple[StackPly, ...]
    solid: "Part.Shape"


class PlyStack:
    """The plies of a layup on a face.

    Attributes:
        layup: the layup, with the direction that was used.
        plies: the StackPlys, from the tool outwards.
        report: the figures of the whole stack as a dict: plies, thickness, tolerance, the largest certified_error and
            edge_error (None where one is not proven), one_fit (all surfaces are members of one family, with the same
            knots and trimming curves), partial_plies (those with a boundary), warnings (texts about what is right but
            hardly wanted) and elapsed_ms; with boundaries also boundary_gaps (the largest distance seen of each from the
            face, by name), inset_error, seam_moved and steep_ramps: where ramps that lie over each other are steeper than
            one of them alone, the worst place for every boundary or set of boundaries, as a list of dicts: slope, alone,
            where, plies and boundaries (names) and the longest ramp in mm.
        base_face: the lay-up face, to whose parameters all that takes parameters refers. Where boundaries cross the seam of
            a closed face, it is the same face with its seam elsewhere, and seam_moved in the report is true.
    """

    def __init__(
        self,
        layup: Layup,
        plies: Sequence[StackPly],
        report: Dict[str, Any],
        base_face: "Part.Face",
        max_degree: Optional[int] = None,
    ) -> None:
        self.layup = layup
        self._max_degree = max_degree
        self.plies: Tuple[StackPly, ...] = tuple(replace(ply, _stack=self) for ply in plies)
        self.report = report
        self.base_face = base_face

    @property
    def bottom_face(self) -> "Part.Face":
        """The first ply's side towards the tool."""
        return self.plies[0].bottom_face

    @property
    def top_face(self) -> "Part.Face":
        """The last ply's side away from the tool."""
        return self.plies[-1].top_face

    def to_shape(self, solids: bool = False) -> "Part.Compound":
        """A compound of the plies' faces, or of their solids, from the tool outwards."""
        return Part.Compound(self.ply_solids() if solids else [ply.face for ply in self.plies])

    def ply_solids(self) -> "Tuple[Part.Shape, ...]":
        """The plies as valid, closed solids, from the tool outwards. In a stack without boundaries neighbours share the
        face between them, so there is no gap; in one with boundaries every solid has faces of its own, and pockets of
        resin are open beside the ends of plies. On a face with creases a ply is a Part.Compound of as many solids as the
        creases leave parts, with gaps where parts move apart.

        Raises:
            OffsetError: a side of a ply has no surface within the tolerance (tolerance-not-reached); on a face with
                creases, parts cross each other at a crease (kinked-surface) or come upon each other elsewhere
                (self-intersection); or a solid is not valid (invalid-result).
        """
        return self._ply_solids

    def material_solids(self) -> Tuple[MaterialSolid, ...]:
        """Neighbouring plies of one material as one solid each, from the tool outwards. Raises as ply_solids does."""
        runs = [tuple(run) for _, run in groupby(self.plies, key=lambda ply: ply.ply.ply.material)]
        solids = self._solids([(run[0], run[-1]) for run in runs])
        return tuple(MaterialSolid(run[0].ply.ply.material, run, solid) for run, solid in zip(runs, solids))

    def laminate_solid(self) -> "Part.Shape":
        """The whole laminate as one solid, from the first ply's bottom to the last ply's top. Raises as ply_solids
        does."""
        return self._solids([(self.plies[0], self.plies[-1])])[0]

    def mass_properties(self) -> MassProperties:
        """Areas, volumes, masses and centres of gravity of the plies, the materials and the whole stack. They come from
        integrals over the lay-up face, not from a mesh; computed when first asked for."""
        return self._mass_properties

    def fibre_directions(self, ply: Union[int, StackPly], uv: Any, axes: Rosettes) -> "numpy.ndarray[Any, Any]":
        """The unit vectors along the fibres of a ply (of a fabric, the warp).

        Args:
            ply: a StackPly, or its number from 1.
            uv: array (n, 2) of parameters of the lay-up face, which are those of every ply's surface too.
            axes: the Rosette that the ply's angle refers to; it says how the axes are transferred. Where the layup's rows
                name several rosettes, all of them: {"name": Rosette}, with "" for rows that name none.

        Returns:
            array (n, 3), tangent to the ply.

        Raises:
            ValueError: the rosette's first axis stands on the surface at one of the places, there is no such ply, or one
                Rosette is given for plies of several.
            TypeError: an argument is of another kind.
        """
        number = ply.ply.number if isinstance(ply, StackPly) else ply
        if isinstance(number, bool) or not isinstance(number, Integral):
            raise TypeError(f"ply must be a StackPly or its number from 1; it is {ply!r}.")
        if not 1 <= number <= len(self.plies):
            raise ValueError(f"The stack has plies 1 to {len(self.plies)}; there is no ply {number}.")
        physical = [each.ply for each in self.plies]
        row = physical[number - 1].ply
        return fibre_directions(self.base_face, uv, rosette_of(axes, row.rosette, physical), row.angle)

    def thickness(self, places: Any) -> "numpy.ndarray[Any, Any]":
        """The thickness of all plies in mm at places of the lay-up face, 0 beside it.

        Args:
            places: array (n, 2) of parameters, or (n, 3) of points in mm, each of which stands for the nearest point of
                the face's surface. The face's edges belong to it; a point past the surface's end is beside it.

        Returns:
            array (n,).
        """
        return stack_thickness(self, places)

    def core_sample(self, point: Any) -> CoreSample:
        """Which plies lie along the normal through the point of the lay-up face nearest to `point` (x, y, z in mm), and
        from where to where."""
        return core_samples(self, [tuple(point)])[0]

    def core_sample_line(self, start: Any, end: Any, count: int) -> List[CoreSample]:
        """The core samples at `count` points at equal steps from `start` to `end`, both included (x, y, z in mm)."""
        return core_samples(self, line_points(start, end, count))

    @cached_property
    def _ply_solids(self) -> "Tuple[Part.Shape, ...]":
        return self._solids([(ply, ply) for ply in self.plies])

    @cached_property
    def _mass_properties(self) -> MassProperties:
        return measure(self.layup, self.base_face, [ply.ply for ply in self.plies])

    def _solids(self, runs: Sequence[Tuple[StackPly, StackPly]]) -> "Tuple[Part.Shape, ...]":
        """The solids from the first ply's bottom to the last ply's top of every run, all made at once."""
        faces: Dict[float, Any] = {}
        for ply in self.plies:
            faces.setdefault(ply.ply.bottom, ply.bottom_face)
            faces.setdefault(ply.ply.top, ply.top_face)
        index = {distance: i for i, distance in enumerate(faces)}
        ends = [sorted((first.ply.bottom, last.ply.top)) for first, last in runs]
        spans = [(index[low], index[high]) for low, high in ends]
        if all(face.ShapeType == "Face" for face in faces.values()):
            return tuple(_core.ply_solids(list(faces.values()), spans))
        tolerance = self.report["tolerance"]
        parts = _core.creased_ply_solids(self.base_face, list(faces), spans, tolerance, self._max_degree)
        return tuple(Part.Compound(solids) for solids in parts)

    def export(self, path: str, solids: bool = False, schema: str = "AP214") -> None:
        """Writes the stack; replaces a file in one step.

        Args:
            path: the name's ending decides. .step and .stp hold an assembly with one part a ply, .FCStd a part with one
                object a ply, both with names and colours by angle; .iges, .igs, .brep and .brp the bare shapes; .csv the
                table of the plies; .html the ply book; .inp the section of a shell for CalculiX; .h5 and .hdf5 the
                layup on meshes, in the layout "HDF5 composite CAE".
            solids: the plies are written as solids, not as faces.
            schema: of STEP files: "AP214" or "AP242".

        Raises:
            FileError: the ending is not known, or the file cannot be written.
            ValueError: the schema is another one.
            OffsetError: a solid cannot be made, see ply_solids.
        """
        from .export import export_stack

        export_stack(self, path, solids, schema)

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
                "boundary": ply.ply.ply.boundary,
                "over_ramp": ply.over_ramp,
                "ramp": ply.ramp,
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
    solids: bool = False,
    reduce: bool = False,
    boundaries: Optional[Boundaries] = None,
    drop_off: Length = 20.0,
    stagger: Optional[Stagger] = None,
    boundary_gap: Optional[Length] = None,
    ramp_slope: str = "mean",
) -> PlyStack:
    """Lay the plies of a layup on a trimmed face.

    All surfaces come from one analysis and one fit whose error is proven for every distance of the stack, so that many
    plies cost little more than one. Neighbours share their surface: no gap, no overlap.

    A ply with a boundary covers a part of the face. Where it ends, the plies above come down over a ramp; what is left
    open below the ramp is a pocket of resin. Every ply keeps its thickness everywhere on its own part.

    Args:
        face: the lay-up surface, a Part.Face. Its orientation and placement count.
        layup: a Layup, or the path of a layup table or document.
        tolerance: largest deviation of every surface from the exact offset in mm, or a FreeCAD length; above zero.
        direction: "normal" stacks along the face's outward normal, "reversed" against it; None: the layup's own.
        surface: which surface of every ply is its .face: "bottom" (towards the tool), "middle" or "top".
        max_degree: highest degree of the fitted surfaces, from 3 to 7; None leaves the choice to the engine.
        progress: called from time to time with a fraction from 0 to 1; returning False cancels.
        solids: makes the plies' solids at once, so that one that cannot be made is refused here; they are made when
            first asked for otherwise.
        reduce: fits every surface on its own, with the fewest poles that its distance needs and a proof of its own;
            takes a fit for every ply. Stacks with boundaries are not reduced.
        boundaries: what the layup's boundaries stand for: {"name": shape or Boundary}.
        drop_off: length of a ramp as a multiple of the thickness of the ply that ends there, or a FreeCAD length. A ramp
            begins and ends level, so in its middle it is some 1.4 to 1.8 times as steep as in the mean.
        stagger: distances in mm, or FreeCAD lengths, by which successive plies of one boundary keep inside of it: a
            list for every boundary, or {"name": list}.
        boundary_gap: largest distance of a boundary from the face in mm, or a FreeCAD length; a boundary that stands
            farther off is refused. None: a quarter of its own size or of the face's, whichever is less, 1 mm at least.
        ramp_slope: "mean": drop_off is that of a ply's whole ramp; "steepest": nowhere is the ply's own part of a ramp
            steeper, and as much longer. Plies that end along one line add up their slopes.

    Returns:
        PlyStack with .plies[i].face, .solid and .report, .top_face, .report, .to_shape(), .mass_properties().

    Raises:
        LayupError: the layup is wrong, has no active ply, or a ply has a boundary that is not among `boundaries`.
        OffsetError: a distance of the stack was refused; says which, why, where, and what would work.
        ValueError: an argument is out of its range.
        TypeError: an argument is of another kind.
    """
    _check_choice("surface", surface, SURFACES)
    _check_choice("ramp_slope", ramp_slope, RAMP_SLOPES)
    layup = _directed(_read(layup), direction)
    known = named_boundaries(boundaries)
    check_names(layup, tuple(known))
    plies = _physical_plies(layup)
    ramp, kept_inside = drop_off_of(drop_off), insets(plies, stagger)
    gap = None if boundary_gap is None else gap_of(boundary_gap)
    limit = millimetres(tolerance, "tolerance")
    if any(ply.ply.boundary for ply in plies):
        from .partial_stack import Laying, lay_partial_plies

        how = Laying(limit, max_degree, surface, ramp, kept_inside, ramp_slope, gap, progress)
        stack: PlyStack = lay_partial_plies(face, layup, plies, known, how)
    else:
        levels, distances = _levels(plies, surface)
        made = _core.offset_stack(face, distances, limit, max_degree, reduce, progress)
        stack = _whole_plies(face, layup, plies, levels, distances, made, max_degree)
    if solids:
        stack.ply_solids()
    return stack


def _check_choice(name: str, value: str, known: Sequence[str]) -> None:
    if value not in known:
        raise ValueError(f"{name} must be one of {', '.join(known)}; it is {value!r}.")


def _whole_plies(
    face: "Part.Face",
    layup: Layup,
    plies: Sequence[PhysicalPly],
    levels: Sequence[float],
    distances: Sequence[float],
    laid: Tuple[List[Tuple[Any, Dict[str, Any]]], bool, float],
    max_degree: Optional[int],
) -> PlyStack:
    """The stack of plies on the whole face, from the surfaces of all distances."""
    made, one_fit, elapsed = laid
    surfaces = {distance: (shape, OffsetReport(report)) for distance, (shape, report) in zip(distances, made)}
    stacked = [
        StackPly(ply, surfaces[ply.bottom][0], surfaces[ply.top][0], *surfaces[level], face)
        for ply, level in zip(plies, levels)
    ]
    reports = [report for _, report in surfaces.values()]
    report = stack_report(layup, plies, reports, one_fit, elapsed)
    report["warnings"] += _crease_warning(reports)
    return PlyStack(layup, stacked, report, face, max_degree)


def _crease_warning(reports: Sequence[OffsetReport]) -> List[str]:
    """What to know about the stack of a face with creases."""
    torn = [report for report in reports if report.crease]
    if not torn:
        return []
    gaps = [report.gap for report in torn if report.gap is not None]
    width = f" by up to {max(gaps):.3g} mm" if len(gaps) == len(torn) else ""
    start = f"The face has creases that part the plies into {max(report.faces for report in torn)} parts"
    if all(report.crease == "gap" for report in torn):
        solids = "a ply's solids are one for each part"
        if any(report.self_intersection == "undecided" for report in torn):
            solids = "whether they meet elsewhere could not be settled, so they may have no solids"
        return [f"{start}, which stand apart there{width}; {solids}."]
    remedy = "round the creases"
    if not any(report.crease == "both" for report in torn):  # what crosses on one side opens on the other
        both_sides = any(report.crease == "gap" for report in torn)
        other = "all plies on the side that opens" if both_sides else "on the face's other side"
        remedy = f"stack {other}, or {remedy}"
    return [f"{start}, which cross each other there{width}, so that they have no solids; {remedy}."]


def _read(layup: Union[Layup, str]) -> Layup:
    if isinstance(layup, Layup):
        return layup
    from .layup import read_layup

    return read_layup(layup)


def _directed(layup: Layup, direction: Optional[str]) -> Layup:
    return layup if direction is None else replace(layup, direction=direction)


def _physical_plies(layup: Layup) -> Tuple[PhysicalPly, ...]:
    """The physical plies; refuses a layup without any, and grid limits."""
    plies = layup.physical_plies()
    problems = [] if plies else [Problem("active", "no ply", "at least one active ply", unit="layup")]
    for row, ply in enumerate(layup.plies, start=1):
        if ply.active and ply.limits:
            expected = "no grid limits: give boundaries instead"
            problems.append(Problem("limits", repr(dict(ply.limits)), expected, row, "ply"))
    if problems:
        raise LayupError("layup", problems)
    return plies


def _levels(plies: Sequence[PhysicalPly], surface: str) -> Tuple[List[float], List[float]]:
    """The distance of every ply's own surface, and all distances that are needed, each once."""
    levels = [getattr(ply, surface) for ply in plies]
    needed = [distance for ply in plies for distance in (ply.bottom, ply.top)] + levels
    return levels, list(dict.fromkeys(needed))


def stack_report(
    layup: Layup, plies: Sequence[PhysicalPly], reports: Sequence[OffsetReport], one_fit: bool, elapsed: float
) -> Dict[str, Any]:
    """The figures of a whole stack; see PlyStack.report."""
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
        "partial_plies": sum(1 for ply in plies if ply.ply.boundary),
        "warnings": [],
        "elapsed_ms": elapsed,
    }


def _largest(errors: Sequence[Optional[float]]) -> Optional[float]:
    proven = [error for error in errors if error is not None]
    return max(proven) if len(proven) == len(errors) else None
