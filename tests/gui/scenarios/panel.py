# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example panel with two openings, 3.4 m across: a free-form face is offset to both sides in one go."""

import os

import FreeCADGui as Gui
import Part
from PySide import QtGui
from session import OUT, look_at_all, offsets, press, run_command, screenshot, select, start, type_into

BUTTON = QtGui.QDialogButtonBox
STEP = os.path.join(os.environ["LAMINATE_OFFSET_BUILD_DIR"], "Mod", "LaminateOffset", "resources", "examples")


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1580, 980)
    panel = doc.addObject("Part::Feature", "Panel")
    panel.Shape = Part.read(os.path.join(STEP, "panel_two_holes.step"))
    doc.recompute()
    look_at_all()
    for distance in ("200 mm", "-200 mm"):
        select(panel, "Face1")
        run_command()
        type_into("distance", distance)
        press(BUTTON.Ok)
        assert not Gui.Control.activeDialog()
    outside, inside = offsets(doc)
    check(panel.Shape.Face1, outside)
    check(panel.Shape.Face1, inside)
    view = look_at_all()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.Name, outside.Name)
    screenshot("properties")
    Gui.Selection.clearSelection()
    screenshot("both_sides")
    view.saveImage(os.path.join(OUT, "view.png"), 1200, 900, "White")


def check(base, offset) -> None:
    """A valid true B-spline with the panel's three loops and nine edges."""
    assert offset.Status == "ok" and offset.Shape.isValid()
    (face,) = offset.Shape.Faces
    assert face.Surface.TypeId == "Part::GeomBSplineSurface"
    assert len(face.Wires) == len(base.Wires) == 3 and len(face.Edges) == len(base.Edges) == 9
    assert 0 < offset.SampledError.Value <= offset.Tolerance.Value or offset.CertifiedError <= offset.Tolerance
