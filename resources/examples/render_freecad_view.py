# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs inside FreeCAD's GUI (started by render_offset.py) and saves a picture of the 3-D view.

The request is a JSON file named by the environment variable RENDER_REQUEST: base, offset (model files), picture,
width, height (pixels), colours (red, green, blue from 0 to 1) and view (direction of sight). The program ends with
exit code 0 when the picture stands, else 1 with the reason on stderr.
"""

import json
import os
import sys
import traceback

import FreeCAD
import FreeCADGui
import Part
from pivy import coin
from PySide import QtCore

SETTLE_MS = 1500  # the script is run before FreeCAD's event loop settles


def load_request():
    """The request of render_offset.py as a dict."""
    with open(os.environ["RENDER_REQUEST"], encoding="utf-8") as stream:
        return json.load(stream)


def add(document, name, shape, colour, line_width=3.0):
    """Adds the shape to the document in its colour, finely tessellated; returns the object."""
    thing = document.addObject("Part::Feature", name)
    thing.Shape = shape
    view = thing.ViewObject
    view.Deviation = 0.02
    view.AngularDeflection = 4.0
    view.ShapeColor = tuple(colour)
    view.LineColor = tuple(0.35 * part for part in colour)
    view.PointColor = view.LineColor
    view.LineWidth = line_width
    view.PointSize = 1.0
    view.Lighting = "Two side"
    return thing


def normals(base, offset):
    """Lines from the base's corners to the offset's, which show the direction of the offset."""
    pairs = zip(base.Vertexes, offset.Vertexes)
    return Part.Compound([Part.makeLine(a.Point, b.Point) for a, b in pairs if a.Point.distanceToPoint(b.Point) > 1e-3])


def save_picture(request):
    """Opens base and offset in a new document and saves the view."""
    document = FreeCAD.newDocument("Render")
    base, offset = (Part.read(request[name]) for name in ("base", "offset"))
    add(document, "Base", base, request["base_colour"])
    add(document, "Offset", offset, request["offset_colour"]).ViewObject.Transparency = 25
    add(document, "Normals", normals(base, offset), (0.2, 0.2, 0.2), 2.5)
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).activeView()
    light = coin.SoDirectionalLight()  # from above, besides the one at the camera
    light.direction = (-0.2, 0.3, -1.0)
    light.intensity = 0.22
    view.getSceneGraph().insertChild(light, 0)
    view.setAnimationEnabled(False)
    view.setCameraType("Orthographic")
    view.setCameraOrientation(camera_rotation(request["view"]).Q)
    view.fitAll(0.9)
    view.saveImage(request["picture"], request["width"], request["height"], "White")


def camera_rotation(sight):
    """Rotation of a camera which looks along sight with the z axis upright in the picture."""
    back = FreeCAD.Vector(*sight).normalize() * -1.0
    right = FreeCAD.Vector(0, 0, 1).cross(back).normalize()
    return FreeCAD.Rotation(right, back.cross(right), back, "ZXY")


def run():
    """Saves the picture and ends FreeCAD."""
    code = 1
    try:
        save_picture(load_request())
        code = 0
    except Exception:
        traceback.print_exc(file=sys.__stderr__)
    sys.__stderr__.flush()
    os._exit(code)  # FreeCAD would ask about the unsaved document


QtCore.QTimer.singleShot(SETTLE_MS, run)
