# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Rosette"."""

from typing import Any, Optional, Tuple

import FreeCAD as App

from ...features.rosette import add_rosette, set_support
from .base import Command

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP

_CARRIERS = ("Face", "Edge", "Vertex")
#: Coordinate systems of FreeCAD 0.20 and of later versions.
_SYSTEMS = (
    "PartDesign::CoordinateSystem",
    "App::Placement",
    "Part::LocalCoordinateSystem",
    "App::LocalCoordinateSystem",
)


class RosetteCommand(Command):
    """Makes a rosette, the axes that ply angles refer to, on what is selected."""

    NAME = "LaminateOffset_Rosette"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_Rosette", "Rosette")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_Rosette",
        "Makes the axes that ply angles refer to, on a face, an edge, a point or a coordinate system",
    )
    ACCEL = "L, R"

    def fits(self) -> bool:
        """One face, edge, vertex or coordinate system is selected, or nothing is."""
        import FreeCADGui

        return _selected() is not None or not FreeCADGui.Selection.hasSelection()

    def run(self, doc: Any) -> None:
        """Opens the panel on a new rosette; OK keeps it, Cancel takes it back."""
        from ..panels.rosette import open_new

        found = _selected()
        feature = self.create(doc, *found[:2]) if found else self.create(doc)
        if found and found[2] is not None:
            feature.Point = found[2]
        open_new(feature)

    @staticmethod
    def create(doc: Any, support: Optional[Any] = None, sub: str = "") -> Any:
        """A rosette on "Face1", "Edge1" or "Vertex1" of an object, or on a coordinate system; not yet computed."""
        feature = add_rosette(doc)
        if support is not None:
            set_support(feature, support, sub)
        return feature


def carries(obj: Any, sub: str) -> bool:
    """Whether a rosette can be attached there."""
    element = sub.rsplit(".", 1)[-1]
    if element:
        return element.startswith(_CARRIERS)
    return getattr(obj.getSubObject(sub, 1) or obj, "TypeId", "") in _SYSTEMS


def _selected() -> Optional[Tuple[Any, str, Optional[Any]]]:
    """(object, path, picked point) of the only thing that is selected, if a rosette can be attached to it."""
    import FreeCADGui

    found = []
    for entry in FreeCADGui.Selection.getSelectionEx("", 0):
        points = list(entry.PickedPoints)
        for index, sub in enumerate(entry.SubElementNames or ("",)):
            found.append((entry.Object, sub, points[index] if index < len(points) else None))
    return found[0] if len(found) == 1 and carries(*found[0][:2]) else None
