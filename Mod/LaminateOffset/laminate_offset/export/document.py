# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stack as a FreeCAD document: a part that holds one object a ply, with its name, colour and figures."""

import os
from typing import TYPE_CHECKING, Any, Dict

import FreeCAD

from ..files import closing_document, save_document
from ..view_settings import Look
from .parts import Part, assembly_name, parts_of

if TYPE_CHECKING:
    from ..stack import PlyStack

_GROUP = "Ply"


def write_document(stack: "PlyStack", path: str, solids: bool = False) -> None:
    """Writes an FCStd file, with faces or with solids. Raises FileError when it cannot be written."""
    name = os.path.splitext(os.path.basename(path))[0]
    with closing_document(lambda: FreeCAD.newDocument(name, hidden=True)) as document:
        container = document.addObject("App::Part", "Stack")
        container.Label = assembly_name(stack)
        looks: Dict[str, Look] = {}
        for part in parts_of(stack, solids):
            feature = _add_ply(document, part)
            container.addObject(feature)
            looks[feature.Name] = Look(part.colour)
        for axis in container.Origin.OriginFeatures:
            axis.Visibility = False
        container.Origin.Visibility = False
        for thing in document.Objects:
            thing.purgeTouched()  # nothing is left to be computed
        save_document(document, path, looks)


def _add_ply(document: Any, part: Part) -> Any:
    physical = part.ply.ply
    feature = document.addObject("Part::Feature", f"Ply{physical.number:03d}")
    feature.Label = part.name
    feature.Shape = part.shape
    add = feature.addProperty
    add("App::PropertyInteger", "Number", _GROUP, "From 1, outwards from the tool").Number = physical.number
    add("App::PropertyString", "PlyMaterial", _GROUP, "Name of the material").PlyMaterial = physical.ply.material
    add("App::PropertyAngle", "FibreAngle", _GROUP, "From the rosette's first axis").FibreAngle = physical.ply.angle
    add("App::PropertyLength", "Thickness", _GROUP, "Of the cured ply").Thickness = physical.thickness
    for side in ("Bottom", "Top"):
        text = f"Signed distance of the {side.lower()} side from the lay-up surface, along its outward normal"
        add("App::PropertyDistance", side, _GROUP, text)
        setattr(feature, side, getattr(physical, side.lower()))
    if feature.ViewObject is not None:
        feature.ViewObject.ShapeColor = part.colour
    return feature
