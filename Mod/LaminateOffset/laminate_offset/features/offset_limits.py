# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far faces can be offset, with the places where an offset would fold first."""

import math
from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

import Part

import laminate_offset as lo

from ..errors import describe_range
from ..messages import place
from ..view_settings import LIMITS_LOOK, ViewProvider
from . import progress
from .base_face import linked_faces, place_result, rooted_links
from .outcome import Feature, accept, add_feature
from .properties import READ_ONLY, Property


class Mark(NamedTuple):
    """A place on a face where a limit is reached.

    Attributes:
        distance: the limit [mm], signed along the face's outward normal.
        point: the place on the face [mm].
        end: where the normal of that length ends: the centre of curvature.
    """

    distance: float
    point: Any
    end: Any


class OffsetLimitsFeature(Feature):
    """Proxy of the Part::FeaturePython object. Its shape is the normal at each place, up to the limit."""

    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.offset_limits", "OffsetLimitsViewProvider", LIMITS_LOOK
    )
    PROPERTIES = (
        Property("App::PropertyLinkSubList", "Base", "Limits", "The faces whose limits are sought"),
        Property(
            "App::PropertyDistance",
            "Negative",
            "Report",
            "Most negative feasible distance; nan: any",
            math.nan,
            READ_ONLY,
        ),
        Property(
            "App::PropertyDistance", "Positive", "Report", "Largest feasible distance; nan: any", math.nan, READ_ONLY
        ),
        Property("App::PropertyBool", "Proven", "Report", "Whether the limits are proven", False, READ_ONLY),
        Property("App::PropertyVectorList", "Places", "Report", "Where the limits are reached", [], READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """The tightest limits of all faces."""
        faces = linked_faces(obj.Base)
        found, marks = progress.run(obj.Label, lambda report: limits_of(faces, report))
        obj.Negative, obj.Positive = (math.nan if mark is None else mark.distance for mark in marks)
        obj.Proven = all(limits.proven for _, limits in found)
        shown = [mark for mark in marks if mark is not None]
        obj.Places = [mark.point for mark in shown]
        place_result(obj, [Part.Compound([_normal(mark) for mark in shown])])
        accept(obj, _message(marks, obj.Proven), [limits.to_dict() for _, limits in found])

    def refused(self, obj: Any) -> None:
        """No figure of an older result is left standing."""
        obj.Negative = obj.Positive = math.nan
        obj.Proven = False
        obj.Places = []


def make_offset_limits(base_obj: Any, sub: Union[str, Iterable[str]], doc: Optional[Any] = None) -> Any:
    """Makes an object that tells how far the faces can be offset. Works with and without the GUI.

    base_obj, sub: the object and its face or faces, e.g. "Face1" or "Body.Pad.Face1" below a container.
    doc: the document that gets the object; base_obj's when omitted.
    """
    feature = add_offset_limits(doc or base_obj.Document)
    feature.Base = rooted_links([(base_obj, [sub] if isinstance(sub, str) else sub)])
    feature.Document.recompute([feature])
    return feature


def add_offset_limits(doc: Any) -> Any:
    """Adds limits that have no base face yet."""
    return add_feature(doc, OffsetLimitsFeature, "OffsetLimits")


def limits_of(
    faces: List[Tuple[str, Any]], report: Optional[progress.Report]
) -> Tuple[List[Any], List[Optional[Mark]]]:
    """Every face with its limits, and the tightest of them on the negative and the positive side."""
    found = []
    for index, (name, face) in enumerate(faces):
        if report is not None and not report(index / len(faces)):
            raise lo.OffsetError("cancelled", "analysis", "The search was cancelled.")
        found.append((face, _limits(name, face)))
    return found, [_tightest(found, side) for side in ("negative", "positive")]


def _limits(name: str, face: Any) -> Any:
    try:
        return lo.offset_limits(face)
    except lo.OffsetError as error:
        error.face = name
        raise


def _tightest(found: List[Tuple[Any, Any]], side: str) -> Optional[Mark]:
    """The least limit in size on one side, where any face has one."""
    limited = [
        (abs(getattr(limits, side)), face, limits) for face, limits in found if getattr(limits, side) is not None
    ]
    if not limited:
        return None
    _, face, limits = min(limited, key=lambda entry: entry[0])
    distance, where = getattr(limits, side), getattr(limits, f"where_{side}")
    point = face.valueAt(where["u"], where["v"])
    return Mark(distance, point, point + face.normalAt(where["u"], where["v"]) * distance)


def _normal(mark: Mark) -> Any:
    """The normal as a line; a point where the limit is zero."""
    return Part.makeLine(mark.point, mark.end) if mark.distance else Part.Vertex(mark.point)


def _message(marks: List[Optional[Mark]], proven: bool) -> str:
    low, high = (None if mark is None else mark.distance for mark in marks)
    text = f"Feasible distances: {describe_range((low, high))}{'' if proven else ' (sampled, not proven)'}."
    for mark in marks:
        if mark is not None:
            where = {"x": mark.point.x, "y": mark.point.y, "z": mark.point.z}
            text += f" {mark.distance:.6g} mm is reached at {place(where)}."
    return text
