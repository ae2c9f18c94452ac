# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plane section of a ply stack as a document object: the cut faces of all plies."""

import json
from typing import Any, List

import FreeCAD as App
import numpy
import Part

from ..view_settings import SAMPLE_LOOK, ViewProvider
from . import progress
from .base_face import BaseFaceError, container_placement, place_result
from .outcome import Feature, accept, add_feature
from .plane_section import Cut, outline_lengths, plane_cuts
from .ply_stack import ply_reports, result_of
from .properties import HIDDEN, READ_ONLY, Property


class StackSectionFeature(Feature):
    """Proxy of the Part::FeaturePython object. Its shape has the true cut of every ply; the view may exaggerate the
    thickness, for which the corners of all cuts and their places on the lay-up face are kept."""

    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.stack_section", "StackSectionViewProvider", SAMPLE_LOOK
    )
    PROPERTIES = (
        Property("App::PropertyLink", "Stack", "Section", "The ply stack"),
        Property("App::PropertyVector", "Normal", "Section", "The plane's normal", App.Vector(1, 0, 0)),
        Property("App::PropertyDistance", "Position", "Section", "Of the plane, from the origin along its normal", 0.0),
        Property(
            "App::PropertyIntegerConstraint", "Cells", "Section", "Samples along each parameter", (96, 8, 1000, 8)
        ),
        Property("App::PropertyInteger", "PlyCount", "Report", "Plies that are cut", 0, READ_ONLY),
        Property("App::PropertyLength", "Length", "Report", "Of the longest cut", 0.0, READ_ONLY),
        Property("App::PropertyVectorList", "Trace", "Section", "Feet of the corners", [], READ_ONLY | HIDDEN),
        Property("App::PropertyVectorList", "Corners", "Section", "Of all cuts", [], READ_ONLY | HIDDEN),
        Property(
            "App::PropertyIntegerList", "Cuts", "Section", "Ply and number of corners a cut", [], READ_ONLY | HIDDEN
        ),
    )

    def compute(self, obj: Any) -> None:
        """Cuts all plies."""
        stack, normal = _stack(obj), _unit(obj.Normal)
        result, position, cells = result_of(stack), obj.Position.Value, obj.Cells
        cuts = progress.run(obj.Label, lambda report: plane_cuts(result, normal, position, cells, report))
        if not cuts:
            raise ValueError("The plane does not cut the stack; change its position or its normal.")
        outlines = [cut.outline() for cut in cuts]
        place_result(obj, [Part.Compound([_cut_face(outline, normal) for outline in outlines])])
        obj.Trace = _vectors([numpy.concatenate([cut.trace, cut.trace[::-1]]) for cut in cuts])
        obj.Corners = _vectors(outlines)
        obj.Cuts = [number for cut, outline in zip(cuts, outlines) for number in (cut.number, len(outline))]
        lengths = outline_lengths(cuts)
        obj.PlyCount, obj.Length = len(lengths), max(lengths.values())
        met = [report for report in ply_reports(stack) if report["number"] in lengths]
        accept(obj, f"{obj.PlyCount} plies are cut, {obj.Length.Value:.6g} mm long", [_entry(report) for report in met])

    def refused(self, obj: Any) -> None:
        """No figure of an older section is left standing."""
        obj.PlyCount, obj.Length = 0, 0


def make_stack_section(stack: Any, normal: Any, position: float) -> Any:
    """Makes a section of a ply stack by a plane and recomputes it. Works with and without the GUI.

    normal: the plane's. position: its distance from the origin along the normal [mm].
    """
    feature = add_stack_section(stack.Document)
    feature.Stack = stack
    feature.Normal, feature.Position = App.Vector(*normal), position
    feature.Document.recompute()
    return feature


def add_stack_section(doc: Any) -> Any:
    """Adds a section that has neither stack nor plane yet."""
    return add_feature(doc, StackSectionFeature, "StackSection")


def set_usual_plane(feature: Any) -> None:
    """Puts the plane through the middle of the stack, across its longer side."""
    box = global_box(feature.Stack)
    sizes = (box.XLength, box.YLength)
    feature.Normal = App.Vector(1, 0, 0) if sizes[0] >= sizes[1] else App.Vector(0, 1, 0)
    feature.Position = feature.Normal.dot(box.Center)


def global_box(stack: Any) -> Any:
    """The box around a stack in the document's global frame, whatever containers the stack stands in."""
    shape = stack.Shape.copy()
    shape.Placement = container_placement(stack).multiply(shape.Placement)
    return shape.BoundBox


def usual_exaggeration(feature: Any) -> float:
    """A round factor with which the stack is some twentieth as thick as its cut is long; at least 1."""
    thickness = sum(abs(entry["top"] - entry["bottom"]) for entry in ply_entries(feature))
    if not thickness:
        return 1.0
    wanted = max(1.0, 0.05 * feature.Length.Value / thickness)
    power = 10.0 ** numpy.floor(numpy.log10(wanted))
    return float(max(step * power for step in (1.0, 2.0, 5.0) if step * power <= wanted * (1.0 + 1e-9)))


def ply_entries(feature: Any) -> List[Any]:
    """Number, name, material, angle and distances of every ply that is cut."""
    return json.loads(feature.ReportJson) if feature.Status == "ok" else []


def cuts_of(feature: Any) -> List[Cut]:
    """The cuts that a section has kept, in the document's global frame."""
    trace, corners = (numpy.array([tuple(point) for point in points]) for points in (feature.Trace, feature.Corners))
    cuts, start = [], 0
    for number, count in zip(feature.Cuts[::2], feature.Cuts[1::2]):
        half = count // 2
        low = slice(start, start + half)
        bottom = corners[low] - trace[low]
        top = corners[start + half : start + count][::-1] - trace[low]
        side = _directions(top - bottom)
        ends = [(part * side).sum(axis=1) for part in (bottom, top)]
        cuts.append(Cut(number, trace[low], side, *ends))
        start += count
    return cuts


def _directions(vectors: Any) -> Any:
    lengths = numpy.linalg.norm(vectors, axis=1)
    return vectors / numpy.where(lengths > 0, lengths, 1.0)[:, None]


def _stack(obj: Any) -> Any:
    if obj.Stack is None:
        raise BaseFaceError("null-shape", "No ply stack is chosen; edit the section and choose one.")
    if obj.Stack.Status != "ok":
        raise BaseFaceError("null-shape", f"{obj.Stack.Label} was refused: {obj.Stack.Message}")
    return obj.Stack


def _unit(vector: Any) -> Any:
    values = numpy.array(tuple(vector))
    length = numpy.linalg.norm(values)
    if not length:
        raise ValueError("The plane's normal is zero; give it a direction.")
    return values / length


def _cut_face(outline: Any, normal: Any) -> Any:
    """A plane face between two splines through the corners and the lines that join their ends, its normal that of the
    plane."""
    around = numpy.cross(outline - outline[0], numpy.roll(outline, -1, axis=0) - outline[0]).sum(axis=0) @ normal
    corners = [App.Vector(*point) for point in (outline if around > 0 else outline[::-1])]
    half = len(corners) // 2
    low, high = _spline(corners[:half]), _spline(corners[half:])
    ends = [Part.makeLine(corners[half - 1], corners[half]), Part.makeLine(corners[-1], corners[0])]
    wire = Part.Wire([low, ends[0], high, ends[1]])
    return Part.Face(Part.Plane(corners[0], App.Vector(*normal)), wire)


def _spline(points: List[Any]) -> Any:
    curve = Part.BSplineCurve()
    curve.interpolate(points)
    return curve.toShape()


def _vectors(parts: List[Any]) -> List[Any]:
    return [App.Vector(*point) for part in parts for point in part]


def _entry(report: Any) -> Any:
    return {key: report[key] for key in ("number", "name", "material", "angle", "thickness", "bottom", "top")}
