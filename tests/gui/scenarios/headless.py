# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that were written without the GUI show in it what they hold, and their offsets can be edited."""

import os
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
from models import hide_docks
from PySide import QtGui
from session import OUT, click, edit, faces, look_at_all, press, screenshot, start, type_into

BUTTON = QtGui.QDialogButtonBox
BUILD = os.environ["LAMINATE_OFFSET_BUILD_DIR"]
ADDON = os.path.join(BUILD, "Mod", "LaminateOffset")
EXAMPLES = os.path.join(ADDON, "resources", "examples")
PANEL = os.path.join(EXAMPLES, "panel_two_holes.step")

#: What a user may do in freecadcmd: FreeCAD's own saveAs, which stores no view settings.
_PLAIN = f"""
import sys
sys.path.append({ADDON!r})
from laminate_offset.features.offset_face import make_offset_face
import FreeCAD
doc = FreeCAD.newDocument("Plain")
ball = doc.addObject("Part::Sphere", "Ball")
doc.recompute()
make_offset_face(ball, "Face1", 2)
doc.saveAs("plain.FCStd")
"""


def run() -> None:
    """Called by scenario_runner.py."""
    start(1280, 720)
    hide_docks()
    result_of_the_command_line()
    plain_document()
    example_script()


def made_by(*command: str) -> str:
    """Runs a command that writes its last argument; returns the path."""
    done = subprocess.run(command, cwd=OUT, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return os.path.join(OUT, command[-1])


def result_of_the_command_line() -> None:
    """The offset is visible, in its own colour, and there is nothing to recompute."""
    tool = os.path.join(BUILD, "bin", "laminate-offset")
    doc = App.openDocument(made_by(tool, "offset", PANEL, "--face", "1", "--distance", "5", "-o", "result.FCStd"))
    (offset,) = doc.Objects
    assert offset.Visibility and offset.ViewObject.Visibility and offset.ViewObject.Transparency > 0
    assert offset.State == ["Up-to-date"], offset.State
    look_at_all()
    screenshot("command_line")
    App.closeDocument(doc.Name)


def plain_document() -> None:
    """An offset without view settings gets its view provider, and becomes visible."""
    subprocess.run(["/usr/bin/python3", "-c", _PLAIN], cwd=OUT, stdin=subprocess.DEVNULL, check=True)
    doc = App.openDocument(os.path.join(OUT, "plain.FCStd"))
    check_editing(doc.getObject("OffsetFace"))
    App.closeDocument(doc.Name)


def example_script() -> None:
    """Base and offset are visible; the offset is edited by a double click."""
    script = os.path.join(EXAMPLES, "offset_headless.py")
    doc = App.openDocument(made_by("/usr/bin/python3", script, PANEL, "--distance", "100", "--out", "example.FCStd"))
    base, offset = doc.getObject("Base"), doc.getObject("OffsetFace")
    assert base.Visibility and base.ViewObject.Visibility
    look_at_all()
    edit(offset)
    type_into("distance", "200")
    click("preview")
    screenshot("base_and_offset")
    press(BUTTON.Cancel)
    assert offset.Distance.Value == 100
    check_editing(offset)
    App.closeDocument(doc.Name)


def check_editing(offset) -> None:
    """A double click opens our panel, and OK keeps the new distance."""
    view = offset.ViewObject
    assert offset.Visibility and view.Visibility and view.Transparency > 0
    assert type(view.Proxy).__name__ == "OffsetFaceViewProvider" and os.path.exists(view.Proxy.getIcon())
    edit(offset)
    assert Gui.Control.activeDialog() and faces()[0].endswith(": Face1")
    type_into("distance", "3")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog() and offset.Status == "ok" and offset.Distance.Value == 3
