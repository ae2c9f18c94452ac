# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary of the pad of layup_inactive_ply.csv on panel_two_holes.step, as an FCStd file that holds it by its label.

python3 panel_boundaries.py --out panel_boundaries.FCStd
"""

import argparse

from trimmed_face import FreeCAD, Part  # finds FreeCAD's libraries

LABEL = "PadContour"
#: In the panel's parameters: low u, high u, low v, high v.
PAD = (0.44, 0.55, 0.40, 0.62)


def contour(face):
    """A closed wire along parameter lines of the panel."""
    surface = face.Surface
    u0, u1, v0, v1 = surface.bounds()
    a, b = (u0 + part * (u1 - u0) for part in PAD[:2])
    c, d = (v0 + part * (v1 - v0) for part in PAD[2:])
    sides = [(surface.vIso(c), a, b), (surface.uIso(b), c, d), (surface.vIso(d), a, b), (surface.uIso(a), c, d)]
    return Part.Wire([curve.toShape(first, last) for curve, first, last in sides])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--panel", default="panel_two_holes.step", help="the panel (default: %(default)s)")
    parser.add_argument("--out", default="panel_boundaries.FCStd", help="the file (default: %(default)s)")
    given = parser.parse_args()
    document = FreeCAD.newDocument("Boundaries")
    thing = document.addObject("Part::Feature", LABEL)
    thing.Label = LABEL
    thing.Shape = contour(Part.read(given.panel).Faces[0])
    document.saveAs(given.out)
    FreeCAD.closeDocument(document.Name)


if __name__ == "__main__":
    main()
