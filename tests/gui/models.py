# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scenarios work on: a document with a free-form face or a plate with a boundary, in a window of known size."""

import math
from typing import Any, Tuple

import FreeCAD as App
import FreeCADGui as Gui
import Part
from laminate_offset.features.layup import make_layup, set_layup
from laminate_offset.features.ply_stack import make_ply_stack
from laminate_offset.layup import Layup
from PySide import QtGui
from session import look_at_all, start


def wavy_document(width: int = 1400, height: int = 900) -> Tuple[Any, Any]:
    """A new document, and in it a free-form face of 70 x 70 mm whose radii of curvature are above 15 mm."""
    doc = start(width, height)
    surface = Part.BSplineSurface()
    rows = range(8)
    surface.interpolate(
        [[App.Vector(10 * i, 10 * j, 5 * math.sin(0.7 * i) * math.cos(0.6 * j)) for j in rows] for i in rows]
    )
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = surface.toShape()
    doc.recompute()
    look_at_all()
    return doc, base


def plate_stack(doc: Any, layup: Layup, boundary: Any) -> Any:
    """A stack on a square of 100 x 100 mm, whose plies have this boundary."""
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length = plane.Width = 100
    doc.recompute()
    rows = make_layup(doc)
    set_layup(rows, layup)
    doc.recompute()
    stack = make_ply_stack(plane, "Face1", rows)
    assert stack.Boundaries == [boundary]
    look_at_all()
    return stack


def only(doc: Any, name: str) -> Any:
    """The one object of a name."""
    (found,) = [obj for obj in doc.Objects if obj.Name.startswith(name)]
    return found


def hide_docks() -> None:
    """Leaves more of a small window to the task panel and the 3-D view."""
    for name in ("Python console", "Report view"):
        for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget, name):
            dock.hide()
