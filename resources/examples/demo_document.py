# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a FreeCAD document which holds a face of a model and its parametric offset.

Usage: demo_document.py MODEL FACE DISTANCE TOLERANCE OUT.FCStd

MODEL is a STEP, IGES or BREP file, FACE its number from 1, DISTANCE and TOLERANCE are in mm. The add-on's folder must be
on PYTHONPATH. Exit code 0 when the document stands, 1 with the reason on stderr when the offset was refused.
"""

import os
import sys
import zipfile
from typing import Mapping, Sequence, Tuple

from laminate_offset.features.offset_face import make_offset_face  # first: it finds FreeCAD's libraries

import FreeCAD
import Part


def gui_document(colours: Mapping[str, Tuple[float, float, float]]) -> str:
    """GuiDocument.xml which shows the named objects in their colours.

    FreeCAD hides the objects of a document that was written without its GUI and so has no such part.
    """
    views = "".join(
        '<ViewProvider name="%s" expanded="0"><Properties Count="2">'
        '<Property name="ShapeColor" type="App::PropertyColor"><PropertyColor value="%d"/></Property>'
        '<Property name="Visibility" type="App::PropertyBool"><Bool value="true"/></Property>'
        "</Properties></ViewProvider>" % (name, packed(colour))
        for name, colour in colours.items()
    )
    return (
        "<?xml version='1.0' encoding='utf-8'?>\n"
        '<Document SchemaVersion="1"><ViewProviderData Count="%d">%s</ViewProviderData>'
        '<Camera settings=""/></Document>\n' % (len(colours), views)
    )


def packed(colour: Tuple[float, float, float]) -> int:
    """A colour as FreeCAD stores it: red, green, blue and transparency, a byte each."""
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8


def main(arguments: Sequence[str]) -> int:
    """Runs the command; returns its exit code."""
    if len(arguments) != 5:
        print(__doc__, file=sys.stderr)
        return 2
    model, face, distance, tolerance, out = arguments
    document = FreeCAD.newDocument("Demo")
    base = document.addObject("Part::Feature", "Base")
    base.Shape = Part.read(model)
    document.recompute()
    offset = make_offset_face(base, "Face%d" % int(face), float(distance), float(tolerance), name="Offset")
    if offset.Shape.isNull() or "Invalid" in offset.State:
        print("demo_document: %s" % offset.Message, file=sys.stderr)
        return 1
    temporary = out + ".part.FCStd"
    document.saveAs(temporary)
    with zipfile.ZipFile(temporary, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("GuiDocument.xml", gui_document({"Base": (0.62, 0.70, 0.82), "Offset": (1.00, 0.66, 0.20)}))
    os.replace(temporary, out)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
