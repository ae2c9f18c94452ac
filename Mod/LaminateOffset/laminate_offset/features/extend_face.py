# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric extension of faces past their sides."""

from typing import Any, Iterable, List, Optional, Union

import laminate_offset as lo

from ..view_settings import EXTENSION_LOOK, ViewProvider
from .base_face import linked_faces, place_result, rooted_links
from .outcome import Feature, accept, add_feature
from .properties import READ_ONLY, Property

#: The sides by the names of their properties.
SIDES = {"UMin": "u-min", "UMax": "u-max", "VMin": "v-min", "VMax": "v-max"}
CONTINUITIES = ["G1", "natural"]
RULES = ["mean", "at-least"]


class ExtendFaceFeature(Feature):
    """Proxy of the Part::FeaturePython object."""

    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.extend_face", "ExtendFaceViewProvider", EXTENSION_LOOK
    )
    PROPERTIES = (
        Property("App::PropertyLinkSubList", "Base", "Extension", "The faces that are extended"),
        Property("App::PropertyLength", "Length", "Extension", "Arc length of the extension", 10.0),
        *(
            Property("App::PropertyBool", name, "Extension", f"Whether the side {side} is extended", True)
            for name, side in SIDES.items()
        ),
        Property("App::PropertyEnumeration", "Continuity", "Extension", "How the surface goes on", CONTINUITIES),
        Property("App::PropertyEnumeration", "Rule", "Extension", "Which iso-curves have the length", RULES),
        Property("App::PropertyFloat", "JoinAngle", "Report", "Largest angle seen at a join [rad]", 0.0, READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """Extends every face; one refusal refuses all."""
        sides = [side for name, side in SIDES.items() if getattr(obj, name)]
        if not sides:
            raise ValueError("No side is chosen; tick at least one of the four sides.")
        results = []
        for name, face in linked_faces(obj.Base):
            try:
                results.append(lo.extend_face(face, obj.Length.Value, sides, obj.Continuity, obj.Rule))
            except lo.OffsetError as error:
                error.face = name
                raise
        place_result(obj, [result.face for result in results])
        reports = [result.report.to_dict() for result in results]
        obj.JoinAngle = max(_join_angles(reports))
        accept(obj, "; ".join(result.report.summary() for result in results), reports)

    def refused(self, obj: Any) -> None:
        """No figure of an older result is left standing."""
        obj.JoinAngle = 0.0


def _join_angles(reports: Iterable[Any]) -> List[float]:
    return [side["join_angle"] or 0.0 for report in reports for side in report["sides"]]


def make_extend_face(
    base_obj: Any,
    sub: Union[str, Iterable[str]],
    length: float,
    doc: Optional[Any] = None,
    name: Optional[str] = None,
) -> Any:
    """Makes a parametric extension of all four sides and recomputes it. Works with and without the GUI.

    base_obj, sub: the object and its face or faces, e.g. "Face1" or "Body.Pad.Face1" below a container.
    length: arc length of the extension [mm].
    doc: the document that gets the object; base_obj's when omitted.
    name: the object's name; "ExtendFace" when omitted.
    """
    feature = add_extend_face(doc or base_obj.Document, name)
    feature.Base = rooted_links([(base_obj, [sub] if isinstance(sub, str) else sub)])
    feature.Length = length
    feature.Document.recompute([feature])
    return feature


def add_extend_face(doc: Any, name: Optional[str] = None) -> Any:
    """Adds an extension that has no base face yet."""
    return add_feature(doc, ExtendFaceFeature, name or "ExtendFace")
