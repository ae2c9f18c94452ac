# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric offset of one or several faces."""

import json
import math
from typing import Any, Iterable, List, Mapping, Optional, Tuple, Union

import FreeCAD as App
import Part

import laminate_offset as lo

from .. import messages
from ..view_settings import OFFSET_LOOK, ViewProvider
from . import progress
from .base_face import linked_faces, place_result, rooted
from .properties import HIDDEN, READ_ONLY, Property, add_missing
from .stateless import StatelessProxy

METHODS = ["same-parameter", "ravi-kumar"]

_PROPERTIES = (
    Property("App::PropertyLinkSub", "Base", "Offset", "The faces that are offset"),
    Property("App::PropertyDistance", "Distance", "Offset", "Signed distance along the face's outward normal", 1.0),
    Property("App::PropertyLength", "Tolerance", "Offset", "Largest deviation from the exact offset", 1e-3),
    Property("App::PropertyEnumeration", "Method", "Offset", "How the offset surface is found", METHODS),
    Property(
        "App::PropertyIntegerConstraint", "MaxDegree", "Offset", "Highest degree of the surface, 3 to 7", (7, 3, 7, 1)
    ),
    Property("App::PropertyString", "Status", "Report", "ok, or the refusal's name", "", READ_ONLY),
    Property(
        "App::PropertyString", "Message", "Report", "What was made, or why not and what would work", "", READ_ONLY
    ),
    Property(
        "App::PropertyLength",
        "CertifiedError",
        "Report",
        "Proven bound of the surface's deviation",
        math.nan,
        READ_ONLY,
    ),
    Property(
        "App::PropertyLength", "SampledError", "Report", "Largest deviation seen; not a bound", math.nan, READ_ONLY
    ),
    Property("App::PropertyLength", "EdgeError", "Report", "Bound of the edge curves' deviation", math.nan, READ_ONLY),
    Property(
        "App::PropertyLength",
        "SampledEdgeError",
        "Report",
        "Largest edge deviation seen; not a bound",
        math.nan,
        READ_ONLY,
    ),
    Property("App::PropertyInteger", "Poles", "Report", "Control points; 0 for exact surfaces", 0, READ_ONLY),
    Property("App::PropertyInteger", "Degree", "Report", "Highest degree; 0 for exact surfaces", 0, READ_ONLY),
    Property("App::PropertyString", "Surface", "Report", "Kind of the offset surface", "", READ_ONLY),
    Property("App::PropertyString", "Limits", "Report", "Feasible distances", "", READ_ONLY),
    Property("App::PropertyString", "ReportJson", "Report", "One report a face, as JSON", "", READ_ONLY | HIDDEN),
)


class OffsetFaceFeature(StatelessProxy):
    """Proxy of the Part::FeaturePython object. It keeps no state: all of it is in properties."""

    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.offset_face", "OffsetFaceViewProvider", OFFSET_LOOK
    )

    def __init__(self, obj: Any):
        obj.Proxy = self
        self._prepare(obj)

    def execute(self, obj: Any) -> None:
        """Called by FreeCAD to recompute."""
        recompute_offset(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Adds what an older version, or a document saved without the GUI, does not have."""
        self._prepare(obj)
        _attach_view_provider(obj)

    @staticmethod
    def _prepare(obj: Any) -> None:
        add_missing(obj, _PROPERTIES)
        # The base decides where the offset is; a placement of its own would break the distance.
        obj.setEditorMode("Placement", READ_ONLY)


def make_offset_face(
    base_obj: Any,
    sub: Union[str, Iterable[str]],
    distance: float,
    tolerance: float = 1e-3,
    doc: Optional[Any] = None,
    name: Optional[str] = None,
) -> Any:
    """Makes a parametric offset and recomputes it. Works with and without the GUI.

    base_obj, sub: the object and its face or faces, e.g. "Face1" or "Body.Pad.Face1" below a container.
    distance: signed distance [mm] along the face's outward normal; a reversed face turns the direction.
    tolerance: largest deviation [mm] from the exact offset.
    doc: the document that gets the object; base_obj's when omitted.
    name: the object's name; "OffsetFace" when omitted.

    A refusal does not raise here: the object's State holds "Invalid", its Status and Message say why.
    """
    feature = add_offset_face(doc or base_obj.Document, name)
    set_base(feature, base_obj, [sub] if isinstance(sub, str) else sub)
    feature.Distance = distance
    feature.Tolerance = tolerance
    feature.Document.recompute([feature])
    return feature


def add_offset_face(doc: Any, name: Optional[str] = None) -> Any:
    """Adds an offset that has no base face yet."""
    feature = doc.addObject("Part::FeaturePython", name or "OffsetFace")
    OffsetFaceFeature(feature)
    _attach_view_provider(feature)
    return feature


def _attach_view_provider(feature: Any) -> None:
    """Where the GUI is up, gives the object the view provider that it does not have yet."""
    if App.GuiUp:
        from ..gui.view_providers.offset_face import attach_missing

        attach_missing(feature.ViewObject)


def set_base(feature: Any, base: Any, subs: Iterable[str]) -> None:
    """Links faces of base, rooted at the outermost container so that moving any container moves the offset."""
    links = [rooted(base, sub) for sub in subs]
    feature.Base = (links[0][0], [path for _, path in links]) if links else (base, [])


def recompute_offset(feature: Any) -> None:
    """Computes shape and report properties. On a refusal the shape becomes empty and RuntimeError is raised."""
    try:
        faces, reports = _offset_all(feature)
    except Exception as error:  # also a defect must not leave the old shape looking valid; it is raised again
        _refuse(feature, error)
        raise RuntimeError(feature.Message) from error
    place_result(feature, faces)
    _write_reports(feature, reports)


def _offset_all(feature: Any) -> Tuple[List[Any], List[Mapping[str, Any]]]:
    bases = linked_faces(feature)
    faces, reports = [], []
    with progress.watch(feature.Label) as report:
        for index, (sub, face) in enumerate(bases):
            try:
                result = _offset_one(feature, face, progress.part_of(report, index, len(bases)))
            except lo.OffsetError as error:
                error.face = sub
                raise
            faces.append(result.shape)
            reports.append(result.report.to_dict())
    return faces, reports


def _offset_one(feature: Any, face: Any, report: Optional[progress.Report]) -> Any:
    return lo.offset_face(
        face,
        feature.Distance.Value,
        tolerance=feature.Tolerance.Value,
        method=feature.Method,
        max_degree=feature.MaxDegree,
        progress=report,
    )


def _refuse(feature: Any, error: Exception) -> None:
    """An empty shape can not be mistaken for a valid offset; the properties say what happened."""
    feature.Shape = Part.Shape()
    feature.Status = _status(error)
    feature.Message = messages.refusal(error, getattr(error, "face", ""))
    _write_figures(feature, [])
    feature.Surface = ""
    feature.Limits = messages.feasible_range(getattr(error, "feasible_range", None))
    feature.ReportJson = json.dumps([_refusal_report(feature, error)])


def _refusal_report(feature: Any, error: Exception) -> Mapping[str, Any]:
    if isinstance(error, lo.OffsetError):
        return error.report.to_dict()
    return {"status": feature.Status, "stage": getattr(error, "stage", "options"), "message": feature.Message}


def _status(error: Exception) -> str:
    bad_argument = "invalid-option" if isinstance(error, ValueError) else "kernel-error"
    return str(getattr(error, "status", bad_argument))


def _write_reports(feature: Any, reports: List[Mapping[str, Any]]) -> None:
    feature.Status = "ok"
    feature.Message = "; ".join(messages.summary(report) for report in reports)
    _write_figures(feature, reports)
    feature.Surface = "; ".join(messages.surface_type(report["surface"]) for report in reports)
    feature.Limits = "; ".join(messages.feasible_range(report.get("limits")) for report in reports)
    feature.ReportJson = json.dumps(reports)


def _write_figures(feature: Any, reports: List[Mapping[str, Any]]) -> None:
    """The worst error and degree and the sum of the poles over all faces."""
    feature.CertifiedError = _worst(reports, "certified_error")
    feature.SampledError = _worst(reports, "sampled_error")
    feature.EdgeError = _worst(reports, "edge_error")
    feature.SampledEdgeError = _worst(reports, "sampled_edge_error")
    surfaces = [report["surface"] for report in reports]
    feature.Poles = sum(surface["poles_u"] * surface["poles_v"] for surface in surfaces)
    feature.Degree = max((max(surface["degree_u"], surface["degree_v"]) for surface in surfaces), default=0)


def _worst(reports: List[Mapping[str, Any]], key: str) -> float:
    """NaN unless every face has the figure: a missing bound must not read as zero."""
    figures = [report.get(key) for report in reports]
    if not figures or None in figures:
        return math.nan
    return max(figures)
