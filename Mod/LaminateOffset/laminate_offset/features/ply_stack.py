# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plies of a layup on a face: one compound, or an object for every ply."""

import json
import math
from collections import OrderedDict
from typing import Any, Dict, List, Optional, Tuple

import FreeCAD as App
import Part

import laminate_offset as lo

from ..boundary_texts import sided, sides_of, stagger_of
from ..rosette import fibre_directions
from ..stack import RAMP_SLOPES, SURFACES
from ..view_settings import OFFSET_LOOK, ViewProvider
from . import progress
from .base_face import BaseFaceError, container_placement, linked_faces, place_result, rooted
from .fold_region import with_fold_region
from .layup import layup_of
from .outcome import Feature, accept, add_feature
from .properties import READ_ONLY, Property
from .rosette import RosetteFeature, rosette_of

#: What the engine's messages ask for, and where the panel has it.
_FIELDS = (
    ("say which side the ply is on: left, right, or the side next to a point", "give its label left or right in Sides"),
    (
        "say which side the ply is on (left, right, or the side next to a point)",
        "give its label left or right in Sides",
    ),
    ("allow a boundary gap of", "allow a Boundary gap of"),
    ("The ratio of a ramp's length to the thickness", "Drop-off"),
)
OUTPUTS = ["One compound", "Named plies"]
COLOURS = ["by angle", "by material"]


class PlyStackFeature(Feature):
    """Proxy of the Part::FeaturePython object. Its shape is a compound of the plies, from the tool outwards."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.ply_stack", "PlyStackViewProvider", OFFSET_LOOK)
    PROPERTIES = (
        Property("App::PropertyLinkSub", "Base", "Stack", "The face that the plies are laid on"),
        Property("App::PropertyLink", "Layup", "Stack", "The layup"),
        Property(
            "App::PropertyLinkList", "Boundaries", "Stack", "Curves that bound plies; the layup calls them by label"
        ),
        Property(
            "App::PropertyLink",
            "Rosette",
            "Stack",
            "The axes that angles refer to, where a row of the layup names none",
        ),
        Property("App::PropertyLinkList", "Rosettes", "Stack", "Rosettes; the layup's rows call them by label"),
        Property(
            "App::PropertyStringList",
            "Sides",
            "Stack",
            "The part of the face that plies keep: Label=left; inside or outside of closed boundaries, left or right of open "
            "ones, as seen from outside; inside where nothing is said",
            [],
        ),
        Property("App::PropertyFloat", "DropOff", "Stack", "Length of a ramp over its height, where plies end", 20.0),
        Property(
            "App::PropertyLength", "RampLength", "Stack", "Length of a ramp; 0: DropOff times the ply's thickness", 0.0
        ),
        Property(
            "App::PropertyEnumeration",
            "RampSlope",
            "Stack",
            "Which slope of a ramp DropOff or RampLength stand for",
            list(RAMP_SLOPES),
        ),
        Property(
            "App::PropertyLength",
            "BoundaryGap",
            "Stack",
            "Largest distance of a boundary from the face; 0: a quarter of the boundary's size",
            0.0,
        ),
        Property(
            "App::PropertyStringList",
            "Stagger",
            "Stack",
            "Distances by which successive plies keep inside of their boundary: Label=0,8,16 for each, or 0,8,16 for all",
            [],
        ),
        Property("App::PropertyLength", "Tolerance", "Stack", "Largest deviation of every surface", 1e-3),
        Property("App::PropertyEnumeration", "Surface", "Stack", "Which surface of a ply is made", list(SURFACES)),
        Property(
            "App::PropertyIntegerConstraint",
            "MaxDegree",
            "Stack",
            "Highest degree of the surfaces, 3 to 7",
            (7, 3, 7, 1),
        ),
        Property("App::PropertyBool", "Solids", "Stack", "Solid plies instead of surfaces", False),
        Property("App::PropertyEnumeration", "Output", "Stack", "One compound, or an object for every ply", OUTPUTS),
        Property("App::PropertyEnumeration", "Colours", "Stack", "What the plies' colours stand for", COLOURS),
        Property("App::PropertyLength", "Thickness", "Report", "Of the whole stack", 0.0, READ_ONLY),
        Property("App::PropertyInteger", "PlyCount", "Report", "Plies of the whole stack", 0, READ_ONLY),
        Property(
            "App::PropertyLength", "CertifiedError", "Report", "Proven bound of all surfaces", math.nan, READ_ONLY
        ),
        Property(
            "App::PropertyLength", "EdgeError", "Report", "Bound of the edge curves' deviation", math.nan, READ_ONLY
        ),
    )

    def compute(self, obj: Any) -> None:
        """Lays the plies, from one fit."""
        check_rosettes(obj)
        stack = _stack(obj)
        place_result(obj, [stack.to_shape(solids=obj.Solids)])
        warnings = [*_unknown_rosettes(obj), *stack.report["warnings"]]
        for warning in warnings:
            App.Console.PrintWarning(f"{obj.Label}: {warning}\n")
        accept(obj, stack.summary(), stack.ply_reports(), warnings)
        obj.Thickness = stack.report["thickness"]
        obj.PlyCount = len(stack.plies)
        obj.CertifiedError = _figure(stack.report["certified_error"])
        obj.EdgeError = _figure(stack.report["edge_error"])
        _remember(obj, stack)
        _match_plies(obj)

    def refused(self, obj: Any) -> None:
        """No figure of an older result is left standing."""
        obj.Thickness, obj.PlyCount = 0, 0
        obj.CertifiedError = obj.EdgeError = math.nan


class PlyFeature(Feature):
    """Proxy of one ply of a stack, a Part::FeaturePython object."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.ply_stack", "PlyViewProvider", OFFSET_LOOK)
    PROPERTIES = (
        Property("App::PropertyLink", "Stack", "Ply", "The stack that the ply belongs to", None, READ_ONLY),
        Property("App::PropertyInteger", "Number", "Ply", "From 1, outwards from the tool", 0, READ_ONLY),
        Property("App::PropertyString", "PlyName", "Ply", "Its name in the layup", "", READ_ONLY),
        Property("App::PropertyString", "Material", "Ply", "Its material", "", READ_ONLY),
        Property("App::PropertyAngle", "FibreAngle", "Ply", "Of the fibres, from the rosette's axis", 0.0, READ_ONLY),
        Property(
            "App::PropertyVector",
            "FibreDirection",
            "Ply",
            "Of the fibres where the rosette is; 0: none",
            None,
            READ_ONLY,
        ),
        Property("App::PropertyLength", "Thickness", "Ply", "Of the cured ply", 0.0, READ_ONLY),
        Property("App::PropertyDistance", "Bottom", "Ply", "Signed distance of the side to the tool", 0.0, READ_ONLY),
        Property("App::PropertyDistance", "Top", "Ply", "Signed distance of the side away from it", 0.0, READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """Takes its surface from the stack."""
        if obj.Stack is None:
            raise BaseFaceError("null-shape", "The stack of this ply was deleted; delete the ply, too.")
        if obj.Stack.Status != "ok":
            raise BaseFaceError("null-shape", f"{obj.Stack.Label} was refused: {obj.Stack.Message}")
        reports = ply_reports(obj.Stack)
        if obj.Number > len(reports):
            # The stack has asked FreeCAD to delete this object, which it does only where nothing fails.
            obj.Shape = Part.Shape()
            return
        report = reports[obj.Number - 1]
        shape = obj.Stack.Shape.childShapes(True, True)[obj.Number - 1]
        placement = container_placement(obj.Stack)
        if not placement.isIdentity():
            shape.Placement = placement.multiply(shape.Placement)
        place_result(obj, [shape])
        _describe(obj, report)
        obj.FibreDirection = _fibre_direction(obj.Stack, obj.Number, report["angle"])


def make_ply_stack(
    base_obj: Any, sub: str, layup: Any, tolerance: float = 1e-3, output: str = OUTPUTS[0], name: Optional[str] = None
) -> Any:
    """Makes a parametric ply stack and recomputes it. Works with and without the GUI.

    base_obj, sub: the object and its face, e.g. "Face1" or "Body.Pad.Face1" below a container.
    layup: the Layup object of the document.
    tolerance: largest deviation [mm] of every surface.
    output: one of OUTPUTS.
    """
    feature = add_ply_stack(base_obj.Document, name)
    set_base(feature, base_obj, sub)
    feature.Layup = layup
    link_boundaries(feature)
    link_rosettes(feature)
    feature.Tolerance = tolerance
    feature.Output = output
    feature.Document.recompute()
    if output == OUTPUTS[1]:
        feature.Document.recompute()  # the plies that the first pass has made
    return feature


def add_ply_stack(doc: Any, name: Optional[str] = None) -> Any:
    """Adds a stack that has neither face nor layup yet."""
    feature = add_feature(doc, PlyStackFeature, name or "PlyStack")
    feature.Surface = "top"
    return feature


def set_base(feature: Any, base: Any, sub: str) -> None:
    """Links the face, rooted at the outermost container."""
    root, path = rooted(base, sub)
    feature.Base = (root, [path])


def link_boundaries(feature: Any) -> None:
    """Links the objects of the document whose labels the layup's plies name as their boundaries."""
    if feature.Layup is None or feature.Layup.Status != "ok":
        return
    names = dict.fromkeys(ply.boundary for ply in layup_of(feature.Layup).plies if ply.boundary)
    found = [obj for name in names for obj in feature.Document.getObjectsByLabel(name)[:1] if hasattr(obj, "Shape")]
    if feature.Boundaries != found:
        feature.Boundaries = found


def link_rosettes(feature: Any) -> None:
    """Links the rosettes of the document whose labels the layup's rows name."""
    if feature.Layup is None or feature.Layup.Status != "ok":
        return
    names = dict.fromkeys(ply.rosette for ply in layup_of(feature.Layup).plies if ply.rosette)
    named = [obj for name in names for obj in feature.Document.getObjectsByLabel(name)]
    found = [obj for obj in named if isinstance(getattr(obj, "Proxy", None), RosetteFeature)]
    if feature.Rosettes != found:
        feature.Rosettes = found


def check_rosettes(stack: Any) -> None:
    """Raises BaseFaceError for a linked rosette that was refused."""
    for rosette in [*([stack.Rosette] if stack.Rosette else []), *stack.Rosettes]:
        if rosette.Status != "ok":
            raise BaseFaceError("null-shape", f"{rosette.Label} was refused: {rosette.Message}")


def rosettes_of(stack: Any) -> Dict[str, Any]:
    """The laminate_offset.Rosettes by the names that the layup's rows have for them; "": of rows that name none."""
    found = {rosette.Label: rosette_of(rosette) for rosette in stack.Rosettes}
    return {**found, "": rosette_of(stack.Rosette)} if stack.Rosette else found


def rosette_for_all(stack: Any) -> Any:
    """The one laminate_offset.Rosette that all plies refer to; None where there is none, or where they name several."""
    names = {ply.ply.rosette for ply in layup_of(stack.Layup).physical_plies()}
    return rosettes_of(stack).get(names.pop()) if len(names) == 1 else None


def _unknown_rosettes(stack: Any) -> List[str]:
    """The warning about rows that name rosettes which are not linked: a table may come without them."""
    names = {ply.ply.rosette for ply in layup_of(stack.Layup).physical_plies() if ply.ply.rosette}
    unknown = sorted(names - set(rosettes_of(stack)))
    if not unknown:
        return []
    listed = ", ".join(map(repr, unknown))
    return [f"Fibre directions are unknown where rows name {listed}: make a rosette with that label."]


def check_linked_rosettes(stack: Any) -> None:
    """Raises ValueError where rows refer to a rosette that the stack does not have, which files need."""
    names = {ply.ply.rosette for ply in layup_of(stack.Layup).physical_plies()}
    missing = names - set(rosettes_of(stack))
    unknown = ", ".join(repr(name) for name in sorted(missing) if name)
    if unknown:
        raise ValueError(
            f"Rows of the layup name {unknown} in the column Rosette; make a rosette with that label and edit the stack."
        )
    if missing and names != missing:
        raise ValueError(
            "Some rows of the layup name a rosette and others none; choose a Rosette in the stack's panel for the others. "
            "Ply book and CalculiX section take plies of one rosette only: for these let all rows name the same, or none."
        )


def rosettes_for_plies(stack: Any) -> Optional[Dict[str, Any]]:
    """All laminate_offset.Rosettes that plies refer to, by the names in their rows; None where one of them is not there."""
    known = rosettes_of(stack)
    names = {ply.ply.rosette for ply in layup_of(stack.Layup).physical_plies()}
    return known if names <= set(known) else None


def _fibre_direction(stack: Any, number: int, angle: float) -> Any:
    """Of a ply where its rosette is; zero without a rosette."""
    rosette = rosettes_of(stack).get(layup_of(stack.Layup).physical_plies()[number - 1].ply.rosette)
    if rosette is None:
        return App.Vector()
    ((_, face),) = linked_faces(stack.Base)
    foot = lo.nearest_point(face, [rosette.origin]).uv
    return App.Vector(*fibre_directions(face, foot, rosette, angle)[0])


def _global_shape(obj: Any) -> Any:
    """The shape of an object in the document's global frame."""
    shape = obj.Shape
    placement = container_placement(obj)
    if not placement.isIdentity():
        shape.Placement = placement.multiply(shape.Placement)
    return shape


def plies_of(stack: Any) -> List[Any]:
    """The ply objects of a stack, from the tool outwards."""
    plies = [obj for obj in stack.InList if isinstance(getattr(obj, "Proxy", None), PlyFeature) and obj.Stack == stack]
    return sorted(plies, key=lambda ply: ply.Number)


def ply_reports(stack: Any) -> List[Dict[str, Any]]:
    """What the last good recompute told about every ply; [] when there was none."""
    reports = json.loads(stack.ReportJson) if stack.Status == "ok" else []
    return [
        report for report in reports if "number" in report
    ]  # while undo gives back a refusal, its report may come first


def result_of(stack: Any) -> Any:
    """The laminate_offset.PlyStack behind a stack object that is not refused; made again after a document was loaded."""
    found = _results.get((stack.Document.Name, stack.Name))
    if found is None or found[0] != _state(stack):
        return _remember(stack, _stack(stack))
    return found[1]


#: The latest results with the states that they belong to, by document and object.
_results: "OrderedDict[Tuple[str, str], Tuple[Any, Any]]" = OrderedDict()
_RESULTS = 4


def _remember(stack: Any, result: Any) -> Any:
    _results[stack.Document.Name, stack.Name] = (_state(stack), result)
    while len(_results) > _RESULTS:
        _results.popitem(last=False)
    return result


def _state(stack: Any) -> Any:
    """What a result holds for: its report, and the place of the lay-up face. A container that takes in a stack moves the face
    without a recompute of the stack."""
    ((_, face),) = linked_faces(stack.Base)
    return stack.ReportJson, face.Placement.Matrix.A


def _stack(obj: Any) -> Any:
    faces = linked_faces(obj.Base)
    if len(faces) != 1:
        raise BaseFaceError("not-a-face", "A stack is laid on one face; edit the stack and pick one.")
    if obj.Layup is None:
        raise BaseFaceError("null-shape", "No layup is chosen; edit the stack and choose one.")
    (name, face), layup = faces[0], layup_of(obj.Layup)
    _check_boundaries(obj, layup)
    options = {
        "tolerance": obj.Tolerance.Value,
        "surface": obj.Surface,
        "max_degree": obj.MaxDegree,
        "solids": obj.Solids,
        "boundaries": _boundaries(obj),
        "drop_off": _drop_off(obj),
        "ramp_slope": obj.RampSlope,
        "boundary_gap": obj.BoundaryGap.Value or None,
        "stagger": stagger_of(obj.Stagger, "Stagger"),
    }
    try:
        return progress.run(obj.Label, lambda report: _laid(face, layup, report, options))
    except lo.OffsetError as error:
        error.face, error.message = name, _of_fields(error.message)
        raise
    except lo.LayupError:
        raise
    except ValueError as error:
        raise ValueError(_of_fields(str(error))) from error


def _of_fields(message: str) -> str:
    """A message of the engine with the fields of the panel in its remedy."""
    for asked, field in _FIELDS:
        message = message.replace(asked, field)
    return message


def _check_boundaries(obj: Any, layup: Any) -> None:
    """Raises BaseFaceError for rows whose boundary is not linked."""
    known = [boundary.Label for boundary in obj.Boundaries]
    names = {ply.boundary for ply in layup.plies if ply.active and ply.boundary}
    if not names <= set(known):
        missing = ", ".join(map(repr, sorted(names - set(known))))
        raise BaseFaceError(
            "invalid-layup",
            f"Rows of the layup name the boundary {missing}, which is not among the stack's; give a curve or a sketch that "
            "label and edit the stack, or correct the column Boundary of the layup.",
        )


def _boundaries(obj: Any) -> Any:
    """The boundaries by their labels, with the sides that plies keep."""
    shapes = {boundary.Label: _global_shape(boundary) for boundary in obj.Boundaries}
    return sided(shapes, sides_of(obj.Sides, "Sides"), "Sides", "name it in the layup's column Boundary")


def _drop_off(obj: Any) -> Any:
    """The ramps' length, or else the ratio that gives it."""
    if obj.RampLength.Value:
        return obj.RampLength
    if not obj.DropOff > 0.0:
        raise ValueError(f"Drop-off must be above 0; it is {obj.DropOff:g}. Else give a Ramp length.")
    return obj.DropOff


def _laid(face: Any, layup: Any, report: Optional[progress.Report], options: Dict[str, Any]) -> Any:
    """In any thread: the stack. A refusal because of folds tells where its outermost surfaces fold."""
    return with_fold_region(face, lambda: _ends(layup), lambda: lo.stack_plies(face, layup, progress=report, **options))


def _ends(layup: Any) -> List[float]:
    """The distances of the stack's two outermost surfaces."""
    plies = layup.physical_plies()
    return [plies[0].bottom, plies[-1].top]


def _match_plies(stack: Any) -> None:
    """Makes the ply objects that are missing and deletes those that are too many."""
    plies = plies_of(stack)
    wanted = stack.PlyCount if stack.Output == OUTPUTS[1] else 0
    for number in range(len(plies) + 1, wanted + 1):
        ply = add_feature(stack.Document, PlyFeature, "Ply")
        ply.Stack, ply.Number = stack, number
        ply.Proxy.execute(ply)
        ply.purgeTouched()
    for ply in plies[wanted:]:
        stack.Document.removeObject(ply.Name)


def _describe(ply: Any, report: Dict[str, Any]) -> None:
    if ply.PlyName != report["name"]:
        ply.PlyName = ply.Label = report["name"]
    ply.Material = report["material"]
    ply.FibreAngle = report["angle"]
    ply.Thickness = report["thickness"]
    ply.Bottom, ply.Top = report["bottom"], report["top"]
    accept(ply, f"{report['material']}, {report['angle']:g} deg, {report['thickness']:g} mm", [report])


def _figure(value: Optional[float]) -> float:
    return math.nan if value is None else value
