# SPDX-License-Identifier: LGPL-2.1-or-later
"""The functions for users. Lengths are in mm; distances are signed along the face's outward normal."""

import copy
import json
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Union

import FreeCAD
import numpy
import Part

from . import _core
from .errors import describe_range
from .report import ExtensionReport, OffsetReport

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


@dataclass(frozen=True)
class ExtensionResult:
    """A finished extension.

    Attributes:
        face: the new Part.Face, with the loops and the orientation of the base.
        report: the ExtensionReport; its status is "ok".
    """

    face: "Part.Face"
    report: ExtensionReport


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


@dataclass(frozen=True)
class NearestPoints:
    """The points of a face nearest to n given ones, row by row in the same order.

    Attributes:
        uv: array (n, 2), the parameters on the face's surface.
        points: array (n, 3), the points of the face in mm.
        distance: array (n,), the distances to the given points in mm; zero or more.
    """

    uv: "numpy.ndarray[Any, Any]"
    points: "numpy.ndarray[Any, Any]"
    distance: "numpy.ndarray[Any, Any]"


def nearest_point(face: "Part.Face", points: Any, trimmed: bool = False) -> NearestPoints:
    """Find the points of a face that are nearest to given points.

    A distance is never larger than the least one by more than 1e-11 of the surface's size. Borders, poles and seams
    count; on a seam the parameters of either side may come back. Among equally near points any one is returned. All
    processor cores are used.

    Args:
        face: a Part.Face; its placement counts, its orientation does not.
        points: an array, or a sequence of rows x, y, z, of shape (n, 3), in mm.
        trimmed: False looks on the surface over the face's parameter range (face.ParameterRange); True looks on the
            trimmed face, its edges included.

    Returns:
        NearestPoints with .uv, .points and .distance.

    Raises:
        OffsetError: the face was refused; it says why.
        ValueError: points has another shape or holds a number that is not finite.
        TypeError: face is not a Part shape.
    """
    return NearestPoints(*_core.nearest_point(face, numpy.asarray(points, dtype=float), trimmed))


@dataclass(frozen=True)
class CurveProjection:
    """A curve put onto a face.

    Attributes:
        wire: the image as a Part.Wire whose edges have curves in space and pcurves on the face's surface; a
            Part.Compound of wires where it is in several parts.
        pcurves: the edges' curves in the parameters of the face's surface (Part.Geom2d), in the wire's order, each with
            its range: (curve, first, last).
        certified_error: proven bound in mm of the distance between every edge of the wire and the surface along its
            pcurve. Where edges[i]["on_surface"] is True that edge is the given curve itself, so the bound is the distance
            of the given curve from its image. None where a curve has no closed form.
        distance: the largest distance seen between the given curve and its image, in mm.
        edges: for each edge of the wire a dict with "first", "last" (the given edge's own parameter), "certified_error",
            "sampled_error", "on_surface", "distance", "certified_distance" and "bridged". The last one is True where the image
            crosses a hollow crease, over which the nearest point jumps: there it is farther from the given curve than the
            nearest point by up to the tolerance, or up to a tenth, as samples show.
        certified_distance: proven bound in mm of the distance between the given curve and its image: no point of a
            boundary near the face lies farther from what became of it. None where a curve has no closed form.
    """

    wire: "Union[Part.Wire, Part.Compound]"
    pcurves: List[Any]
    certified_error: Optional[float]
    distance: float
    edges: List[Dict[str, Any]]
    certified_distance: Optional[float]


def project_curve(
    face: "Part.Face",
    edge_or_wire: "Union[Part.Edge, Part.Wire]",
    tolerance: Length = 1e-3,
    outside: str = "clip",
) -> CurveProjection:
    """Put an edge or a wire onto the surface of a face, along the surface's normal.

    A curve that lies on the surface keeps its shape and gets its parametric image; any other one is dropped onto the
    nearest points, and certified_distance says how far it keeps from them. A curve that crosses a seam is split there.
    The face's edges do not cut the image.

    Args:
        face: a Part.Face; its placement counts, its orientation does not.
        edge_or_wire: a Part.Edge or Part.Wire, a ply boundary for instance.
        tolerance: largest deviation in mm, or a FreeCAD length; above zero.
        outside: what becomes of parts whose nearest points lie on the end of the surface: "clip" leaves them out at the
            face's parameter range; "extend" uses the surface beyond that range as far as it reaches and leaves out the rest.

    Returns:
        CurveProjection with .wire, .pcurves, .certified_error and .certified_distance.

    Raises:
        OffsetError: the face or the curve was refused; it says why.
        ValueError: an argument is out of its range or has the wrong unit.
        TypeError: an argument is not a Part shape.
    """
    wire, edges, certified_error, distance, certified_distance = _core.project_curve(
        face, edge_or_wire, millimetres(tolerance, "tolerance"), outside
    )
    on_face = [edge.curveOnSurface(0) for edge in wire.Edges]  # (curve, surface, placement, first, last)
    pcurves = [(curve, first, last) for curve, _, _, first, last in on_face]
    return CurveProjection(wire, pcurves, certified_error, distance, edges, certified_distance)


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
        extension: length in mm, or a FreeCAD length, by which the result is extended past its four sides; zero or more.
            "same-parameter" extends the face as extend_face does, "ravi-kumar" only the surface under the loops, as the
            paper does. The report's errors do not speak of what lies past the base's edges.
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
        millimetres(distance, "distance"),
        millimetres(tolerance, "tolerance"),
        method,
        millimetres(extension, "extension"),
        max_degree,
        progress,
    )
    return OffsetResult(shape, OffsetReport(report))


def extend_face(
    face: "Part.Face",
    length: Length,
    sides: Union[str, Sequence[str]] = "all",
    continuity: str = "G1",
    rule: str = "mean",
) -> ExtensionResult:
    """Extend a trimmed face past its sides.

    The sides are those of the rectangle which holds the face in its surface's parameters. Edges along an extended side
    move outwards with it; all other edges, holes among them, stay. The base face is only read.

    Args:
        face: a Part.Face.
        length: arc length of the extension in mm, or a FreeCAD length; above zero.
        sides: "all", or some of "u-min", "u-max", "v-min" and "v-max": a list, or one text with commas between.
        continuity: "G1" (the mirror image of the part next to the side) or "natural" (the surface's last polynomial
            piece goes on, with every derivative). Planes, cylinders, cones, spheres and tori go on as themselves.
        rule: "mean" (eight iso-curves have the length on the average) or "at-least" (each of them has it).

    Returns:
        ExtensionResult with .face and .report.

    Raises:
        OffsetError: the face was refused, for one that is closed, or an extension that would fold or meet the face.
        ValueError: an argument is out of its range or has the wrong unit.
        TypeError: face is not a Part shape.
    """
    shape, report = _core.extend_face(face, millimetres(length, "length"), _side_names(sides), continuity, rule)
    return ExtensionResult(shape, ExtensionReport(json.loads(report)))


def _side_names(sides: Union[str, Sequence[str]]) -> List[str]:
    names = sides.split(",") if isinstance(sides, str) else list(sides)
    names = [name.strip() for name in names]
    return ["u-min", "u-max", "v-min", "v-max"] if [name.lower() for name in names] == ["all"] else names


def millimetres(length: Any, name: str) -> float:
    """A number in mm from a number or a FreeCAD length; errors call it `name`."""
    if not isinstance(length, FreeCAD.Units.Quantity):
        if isinstance(length, (str, bytes)):
            raise TypeError(f"{name} must be a number in mm or a FreeCAD length, not the text {length!r}.")
        return float(length)
    if length.Unit != FreeCAD.Units.Length:
        raise ValueError(f"{name} must be a length; {length.UserString} is none. Give it in mm.")
    return float(length.Value)  # FreeCAD's internal unit of length is the millimetre
