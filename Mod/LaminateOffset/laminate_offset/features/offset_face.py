# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric offset of one or many faces, of one or several objects."""

import json
import math
from functools import partial
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple, Union

import laminate_offset as lo

from .. import messages
from ..view_settings import OFFSET_LOOK, ViewProvider
from . import progress
from .base_face import BaseFaceError, linked_faces, links_of, place_result, rooted_links
from .fold_region import with_fold_region
from .outcome import Feature, accept, add_feature
from .properties import HIDDEN, READ_ONLY, Property

METHODS = ["same-parameter", "ravi-kumar"]

Link = Tuple[Any, Iterable[str]]


class OffsetFaceFeature(Feature):
    """Proxy of the Part::FeaturePython object. It keeps no state: all of it is in properties."""

    SCHEMA = 2
    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.offset_face", "OffsetFaceViewProvider", OFFSET_LOOK
    )
    PROPERTIES = (
        Property("App::PropertyLinkSubList", "Base", "Offset", "The faces that are offset"),
        Property("App::PropertyInteger", "FaceCount", "Offset", "How many faces were picked", 0, READ_ONLY | HIDDEN),
        Property("App::PropertyDistance", "Distance", "Offset", "Signed distance along the face's outward normal", 1.0),
        Property("App::PropertyLength", "Tolerance", "Offset", "Largest deviation from the exact offset", 1e-3),
        Property("App::PropertyEnumeration", "Method", "Offset", "How the offset surface is found", METHODS),
        Property(
            "App::PropertyIntegerConstraint",
            "MaxDegree",
            "Offset",
            "Highest degree of the surface, 3 to 7",
            (7, 3, 7, 1),
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
        Property(
            "App::PropertyLength", "EdgeError", "Report", "Bound of the edge curves' deviation", math.nan, READ_ONLY
        ),
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
    )

    def compute(self, obj: Any) -> None:
        """Offsets every face; one refusal refuses all."""
        request = OffsetRequest.of(obj)
        results = _take_prepared(obj, request)
        if results is None:
            results = progress.run(obj.Label, request.compute)
        place_result(obj, [result.shape for result in results])
        _write_reports(obj, [result.report.to_dict() for result in results])

    def refused(self, obj: Any) -> None:
        """No figure of an older result is left standing."""
        _write_figures(obj, [])
        obj.Surface = ""
        obj.Limits = messages.feasible_range(_feasible_range(obj))

    def upgrade(self, obj: Any, version: int) -> None:
        """The first version had the faces of one object."""
        obj.FaceCount = sum(len(subs) for _, subs in links_of(obj.Base))


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
    set_base(feature, [(base_obj, [sub] if isinstance(sub, str) else sub)])
    feature.Distance = distance
    feature.Tolerance = tolerance
    feature.Document.recompute([feature])
    return feature


def add_offset_face(doc: Any, name: Optional[str] = None) -> Any:
    """Adds an offset that has no base face yet."""
    return add_feature(doc, OffsetFaceFeature, name or "OffsetFace")


def set_base(feature: Any, links: Iterable[Link]) -> None:
    """Links the faces, each rooted at its outermost container so that moving any container moves the offset."""
    faces = rooted_links(links)
    feature.Base = faces
    feature.FaceCount = len(faces)


class OffsetRequest(NamedTuple):
    """All that one recompute needs, free of the document: it can be computed in any thread."""

    faces: List[Tuple[str, Any]]
    distance: float
    tolerance: float
    method: str
    max_degree: int

    @classmethod
    def of(cls, feature: Any) -> "OffsetRequest":
        """What the object asks for now. Raises BaseFaceError."""
        faces = linked_faces(feature.Base)
        if len(faces) < feature.FaceCount:  # FreeCAD drops the links to an object that is deleted
            raise BaseFaceError(
                "null-shape",
                f"{feature.FaceCount - len(faces)} of {feature.FaceCount} base faces are gone with the object they "
                "were on. Edit the offset and pick faces again.",
            )
        return cls(faces, feature.Distance.Value, feature.Tolerance.Value, feature.Method, feature.MaxDegree)

    def compute(self, report: Optional[progress.Report]) -> List[Any]:
        """An OffsetResult for each face. Raises OffsetError, whose `face` is the name of the refused one."""
        results = []
        for index, (name, face) in enumerate(self.faces):
            try:
                step = progress.part_of(report, index, len(self.faces))
                result = with_fold_region(face, lambda: [self.distance], partial(self._offset, face, step))
            except lo.OffsetError as error:
                error.face = name
                raise
            results.append(result)
        return results

    def _offset(self, face: Any, report: Optional[progress.Report]) -> Any:
        return lo.offset_face(
            face,
            self.distance,
            tolerance=self.tolerance,
            method=self.method,
            max_degree=self.max_degree,
            progress=report,
        )

    def same_as(self, other: "OffsetRequest") -> bool:
        """Whether the other one asks for the same of the same faces."""
        if self[1:] != other[1:] or len(self.faces) != len(other.faces):
            return False
        return all(mine.isEqual(theirs) for (_, mine), (_, theirs) in zip(self.faces, other.faces))


_prepared: Dict[Tuple[str, str], Tuple[OffsetRequest, List[Any]]] = {}


def prepare(feature: Any, request: OffsetRequest, results: List[Any]) -> None:
    """Hands over what a preview has computed: the next recompute takes it if it asks for the same."""
    _prepared[feature.Document.Name, feature.Name] = (request, results)


def _take_prepared(feature: Any, request: OffsetRequest) -> Optional[List[Any]]:
    found = _prepared.pop((feature.Document.Name, feature.Name), None)
    return found[1] if found is not None and found[0].same_as(request) else None


def describe_results(results: Iterable[Any]) -> str:
    """One line for the user on the offsets of all faces, without their limits."""
    return "; ".join(messages.summary({**result.report.to_dict(), "limits": None}) for result in results)


def _feasible_range(feature: Any) -> Any:
    (report,) = json.loads(feature.ReportJson)
    return report.get("limits")


def _write_reports(feature: Any, reports: List[Mapping[str, Any]]) -> None:
    accept(feature, "; ".join(messages.summary(report) for report in reports), reports)
    _write_figures(feature, reports)
    feature.Surface = "; ".join(messages.surface_type(report["surface"]) for report in reports)
    feature.Limits = "; ".join(messages.feasible_range(report.get("limits")) for report in reports)


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
