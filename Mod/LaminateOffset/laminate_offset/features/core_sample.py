# SPDX-License-Identifier: LGPL-2.1-or-later
"""A core sample of a ply stack: which plies are met at a point, and from where to where."""

from typing import Any, Dict

import FreeCAD as App
import Part

from ..view_settings import SAMPLE_LOOK, ViewProvider
from .base_face import BaseFaceError, place_result
from .outcome import Feature, accept, add_feature
from .ply_stack import result_of
from .properties import READ_ONLY, Property


class CoreSampleFeature(Feature):
    """Proxy of the Part::FeaturePython object. Its shape has an edge for every ply, along the face's normal."""

    VIEW_PROVIDER = ViewProvider(
        "laminate_offset.gui.view_providers.core_sample", "CoreSampleViewProvider", SAMPLE_LOOK
    )
    PROPERTIES = (
        Property("App::PropertyLink", "Stack", "Sample", "The ply stack"),
        Property(
            "App::PropertyVectorDistance", "Point", "Sample", "Where the sample is taken: the nearest point of the face"
        ),
        Property("App::PropertyVector", "Foot", "Report", "The point of the face [mm]", None, READ_ONLY),
        Property("App::PropertyVector", "Normal", "Report", "The face's outward normal there", None, READ_ONLY),
        Property("App::PropertyLength", "Thickness", "Report", "Of all plies at the point", 0.0, READ_ONLY),
        Property("App::PropertyInteger", "PlyCount", "Report", "Plies at the point", 0, READ_ONLY),
        Property("App::PropertyStringList", "Plies", "Report", "The plies from the tool outwards", [], READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """Finds the foot of the point and lists the plies there."""
        core = result_of(_stack(obj)).core_sample(obj.Point)
        edges = [Part.makeLine(layer.start, layer.end) for layer in core.layers]
        place_result(obj, [Part.Compound(edges)])
        met = [_entry(layer) for layer in core.layers]
        obj.Foot, obj.Normal = core.foot, core.normal
        obj.Plies = [describe(ply) for ply in met]
        obj.PlyCount = len(met)
        obj.Thickness = core.thickness
        accept(obj, f"{obj.PlyCount} plies, {obj.Thickness.Value:g} mm", met)

    def refused(self, obj: Any) -> None:
        """No figure of an older sample is left standing."""
        obj.Plies, obj.PlyCount, obj.Thickness = [], 0, 0


def make_core_sample(stack: Any, point: Any) -> Any:
    """Makes a core sample of a ply stack at a point [mm] and recomputes it. Works with and without the GUI."""
    feature = add_core_sample(stack.Document)
    feature.Stack = stack
    feature.Point = App.Vector(*point)
    feature.Document.recompute()
    return feature


def add_core_sample(doc: Any) -> Any:
    """Adds a core sample that has neither stack nor point yet."""
    return add_feature(doc, CoreSampleFeature, "CoreSample")


def describe(ply: Dict[str, Any]) -> str:
    """A line for the user, e.g. "1  P1  IM7-8552-134  45 deg  from 0 to 0.134 mm"."""
    return "{number}  {name}  {material}  {angle:g} deg  from {bottom:.6g} to {top:.6g} mm".format(**ply)


def _stack(obj: Any) -> Any:
    if obj.Stack is None:
        raise BaseFaceError("null-shape", "No ply stack is chosen; edit the sample and choose one.")
    if obj.Stack.Status != "ok":
        raise BaseFaceError("null-shape", f"{obj.Stack.Label} was refused: {obj.Stack.Message}")
    return obj.Stack


def _entry(layer: Any) -> Dict[str, Any]:
    ply = layer.ply.ply
    return {
        "number": ply.number,
        "name": ply.name,
        "material": ply.ply.material,
        "angle": ply.ply.angle,
        "thickness": layer.thickness,
        "bottom": layer.bottom,
        "top": layer.top,
    }
