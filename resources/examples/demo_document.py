# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a FreeCAD document which holds a face of a model and its parametric offset.

Usage: demo_document.py MODEL FACE DISTANCE TOLERANCE OUT.FCStd

MODEL is a STEP, IGES or BREP file, FACE its number from 1, DISTANCE and TOLERANCE are in mm. The add-on's folder must be
on PYTHONPATH. Exit code 0 when the document stands, 1 with the reason on stderr when the offset was refused.
"""

import sys
from typing import Sequence

from laminate_offset.features.offset_face import make_offset_face  # first: it finds FreeCAD's libraries
from laminate_offset.files import save_document
from laminate_offset.view_settings import Look

import FreeCAD
import Part

BASE_LOOK = Look((0.62, 0.70, 0.82))
OFFSET_LOOK = Look((1.00, 0.66, 0.20))


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
    save_document(document, out, {"Base": BASE_LOOK, "Offset": OFFSET_LOOK})
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
