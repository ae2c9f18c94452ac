# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layup in a document: a table of plies that is edited, imported and exported, and that ply stacks refer to."""

import json
import os
from typing import Any, Dict, Optional

from ..layup import Layup, LayupError, Ply, Problem, materials, read_layup
from ..layup.cards import known_materials
from ..layup.documents import layup_document, read_document
from ..view_settings import ViewProvider
from .outcome import Feature, accept, add_feature
from .properties import HIDDEN, READ_ONLY, Property

DIRECTIONS = ["normal", "reversed"]
REFERENCES = ["tool", "middle", "top"]
DEFAULT_MATERIAL = "IM7-8552-134"


class LayupFeature(Feature):
    """Proxy of the App::FeaturePython object. The rows are JSON text; the options are properties."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.layup", "LayupViewProvider", None)
    PROPERTIES = (
        Property("App::PropertyString", "Table", "Layup", "Materials and plies as JSON", "", HIDDEN),
        Property("App::PropertyIntegerConstraint", "Repeat", "Layup", "How often the rows are laid", (1, 1, 1000, 1)),
        Property("App::PropertyBool", "Symmetric", "Layup", "Whether the mirror image follows", False),
        Property("App::PropertyBool", "MiddlePly", "Layup", "Whether the last row is the middle of the stack", False),
        Property("App::PropertyEnumeration", "Direction", "Layup", "Along the face's normal or against it", DIRECTIONS),
        Property("App::PropertyEnumeration", "Reference", "Layup", "What lies on the face", REFERENCES),
        Property("App::PropertyLength", "Thickness", "Report", "Of the whole stack", 0.0, READ_ONLY),
        Property("App::PropertyInteger", "PlyCount", "Report", "Plies of the whole stack", 0, READ_ONLY),
        Property("App::PropertyString", "Notation", "Report", "The stack in shorthand", "", READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """Reads the table and counts."""
        layup = layup_of(obj)
        count = len(layup.physical_plies())
        obj.Thickness = layup.thickness
        obj.PlyCount = count
        obj.Notation = layup.notation() if count else ""
        accept(obj, f"{count} plies, {layup.thickness:g} mm", [])

    def refused(self, obj: Any) -> None:
        """No figure of an older table is left standing."""
        obj.Thickness, obj.PlyCount, obj.Notation = 0, 0, ""


def make_layup(doc: Any, layup: Optional[Layup] = None, name: Optional[str] = None) -> Any:
    """Makes a layup in a document and recomputes it; one ply of carbon when none is given. Works without the GUI."""
    feature = add_feature(doc, LayupFeature, name or "Layup", "App::FeaturePython")
    set_layup(feature, layup or Layup((Ply("P1", DEFAULT_MATERIAL),), (materials()[DEFAULT_MATERIAL],)))
    doc.recompute([feature])
    return feature


def import_layup(doc: Any, path: str) -> Any:
    """Makes a layup from a table (.csv) or a document (.json, .yaml), named like the file. Raises LayupError."""
    layup = read_layup(path)
    feature = make_layup(doc, layup)
    feature.Label = os.path.splitext(os.path.basename(path))[0]
    return feature


def layup_of(feature: Any) -> Layup:
    """The layup that the object holds. Raises LayupError, which names every wrong row."""
    try:
        table = json.loads(feature.Table)
    except ValueError as error:
        problem = Problem("Table", "text that is no table", "a table; edit the layup and enter its plies", unit="layup")
        raise LayupError(feature.Label, [problem]) from error
    document = {**table, "repeat": feature.Repeat, "symmetric": feature.Symmetric, "middle_ply": feature.MiddlePly}
    document.update(direction=feature.Direction, reference=feature.Reference)
    return read_document(document, feature.Label, known_materials([]))


def set_layup(feature: Any, layup: Layup) -> None:
    """Stores a layup in the object."""
    document = layup_document(layup)
    options = ("repeat", "symmetric", "middle_ply", "direction", "reference")
    feature.Table = json.dumps({key: value for key, value in document.items() if key not in options})
    feature.Repeat = layup.repeat
    feature.Symmetric = layup.symmetric
    feature.MiddlePly = layup.middle_ply
    feature.Direction = layup.direction
    feature.Reference = layup.reference


def read_rows(document: Dict[str, Any], source: str) -> Layup:
    """The layup of a document whose plies hold texts as a table has them. Raises LayupError."""
    return read_document(document, source, known_materials([]))
