# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offsets one face of a STEP, IGES, BREP or FCStd file without the GUI and stores a parametric FreeCAD document.

In plain Python, with normal options, tracebacks and exit codes (this folder is <add-on>/resources/examples):

    PYTHONPATH=/usr/lib/freecad-python3/lib python3 offset_headless.py panel_two_holes.step --distance 5 --out out.FCStd

In freecadcmd, which takes options of scripts for its own, through runpy:

    freecadcmd -c "import runpy, sys; sys.argv = ['offset_headless.py', 'panel_two_holes.step', '--out', 'out.FCStd'];
        runpy.run_path('offset_headless.py', run_name='__main__')"

Exit codes: 0 done; 1 the face was refused, the reason is on stderr and nothing is written; 2 bad usage or unreadable
input.
"""

import argparse
import os
import sys

# The add-on is two folders up; inside FreeCAD it is on the path anyway.
sys.path.append(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))

import laminate_offset  # noqa: E402  (finds FreeCAD's modules, too)
import FreeCAD as App  # noqa: E402
import Part  # noqa: E402
from laminate_offset.features.offset_face import make_offset_face  # noqa: E402
from laminate_offset.files import FileError, save_document  # noqa: E402


def arguments() -> argparse.Namespace:
    """The command line; lengths are in mm."""
    parser = argparse.ArgumentParser(description="Offset one face of a CAD file into a FreeCAD document.")
    parser.add_argument("input", help="STEP, IGES, BREP or FCStd file")
    parser.add_argument("--face", type=int, default=1, help="number of the face, from 1, as FreeCAD shows it")
    parser.add_argument("--distance", type=float, default=5.0, help="signed distance along the outward normal [mm]")
    parser.add_argument("--tolerance", type=float, default=1e-3, help="largest deviation [mm]")
    parser.add_argument("--out", required=True, help="FCStd file to write")
    return parser.parse_args()


def load(path: str) -> "App.Document":
    """A document that holds the file's shape as the object "Base"."""
    if not os.path.isfile(path):
        raise OSError(f"{path} does not exist; name a STEP, IGES, BREP or FCStd file.")
    doc = App.newDocument("Offset")
    base = doc.addObject("Part::Feature", "Base")
    if path.lower().endswith(".fcstd"):
        source = App.openDocument(path)
        shapes = [obj.Shape for obj in source.RootObjects if hasattr(obj, "Shape") and obj.Shape.Faces]
        base.Shape = Part.Compound(shapes)
        App.closeDocument(source.Name)
    else:
        base.Shape = Part.read(path)
    if not base.Shape.Faces:
        raise OSError(f"{path} holds no face that can be read.")
    return doc


def main() -> int:
    """Runs the job. Returns the exit code."""
    options = arguments()
    try:
        doc = load(options.input)
    except (OSError, Part.OCCError) as error:
        print(f"offset_headless: {error}", file=sys.stderr)
        return 2
    offset = make_offset_face(doc.getObject("Base"), f"Face{options.face}", options.distance, options.tolerance)
    print(f"laminate_offset {laminate_offset.__version__}, Face{options.face} by {options.distance:g} mm")
    if offset.Status != "ok":
        print(f"refused ({offset.Status}): {offset.Message}", file=sys.stderr)
        return 1
    try:
        save_document(doc, options.out)
    except FileError as error:
        print(f"offset_headless: {error}", file=sys.stderr)
        return 2
    print(f"{offset.Message}\nwritten: {os.path.abspath(options.out)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
