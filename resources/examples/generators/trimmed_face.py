# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared pieces of the example generators: spline surfaces through formulas, trimmed faces, STEP files.

Lengths are in mm. The generators need only FreeCAD's Part module and NumPy, so they run in FreeCAD's console,
under freecadcmd, and in plain python3 with FreeCAD's library folder on PYTHONPATH.
"""

import os
import re
import sys
from typing import Callable, List, Sequence, Tuple

import numpy as np

FREECAD_LIBRARY_FOLDERS = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/lib64/freecad/lib")
for folder in FREECAD_LIBRARY_FOLDERS:
    if os.path.isdir(folder) and folder not in sys.path:
        sys.path.append(folder)

import FreeCAD  # noqa: E402  (must come before Part and after the path above)
import Part  # noqa: E402

Range = Tuple[float, float]
Formula = Callable[[float, float], Sequence[float]]

TIME_STAMP = "2000-01-01T00:00:00"  # a fixed date makes the stored files reproducible


def clamped_knots(bounds: Range, poles: int, degree: int) -> np.ndarray:
    """Uniform knot vector over bounds whose end knots have full multiplicity (flat, with repetitions)."""
    inner = np.linspace(bounds[0], bounds[1], poles - degree + 1)
    return np.concatenate((np.repeat(inner[0], degree), inner, np.repeat(inner[-1], degree)))


def greville(knots: np.ndarray, degree: int) -> np.ndarray:
    """Averages of degree successive knots: one interpolation site for each pole."""
    return np.array([knots[i + 1 : i + 1 + degree].mean() for i in range(len(knots) - degree - 1)])


def collocation(sites: np.ndarray, knots: np.ndarray, degree: int) -> np.ndarray:
    """Matrix of all B-spline basis functions (columns) at the sites (rows), by the Cox-de Boor recurrence."""
    last = np.nonzero(knots < knots[-1])[0][-1]  # the end of the range belongs to the last non-empty span
    spans = np.minimum(np.searchsorted(knots, sites, side="right") - 1, last)
    basis = np.zeros((len(sites), len(knots) - 1))
    basis[np.arange(len(sites)), spans] = 1.0
    for order in range(1, degree + 1):
        count = len(knots) - 1 - order
        raised = np.zeros((len(sites), count))
        for i in range(count):
            left, right = knots[i + order] - knots[i], knots[i + order + 1] - knots[i + 1]
            if left > 0:
                raised[:, i] += (sites - knots[i]) / left * basis[:, i]
            if right > 0:
                raised[:, i] += (knots[i + order + 1] - sites) / right * basis[:, i + 1]
        basis = raised
    return basis


def spline_surface(
    formula: Formula, u_range: Range, v_range: Range, poles: Tuple[int, int], degrees: Tuple[int, int] = (3, 3)
) -> Part.BSplineSurface:
    """Tensor-product B-spline surface which interpolates formula(u, v) -> (x, y, z) at the Greville sites.

    A polynomial formula of at most the given degrees is reproduced exactly.
    """
    knots = [clamped_knots(bounds, n, p) for bounds, n, p in zip((u_range, v_range), poles, degrees)]
    sites = [greville(k, p) for k, p in zip(knots, degrees)]
    points = np.array([[formula(u, v) for v in sites[1]] for u in sites[0]], dtype=float)
    matrices = [collocation(s, k, p) for s, k, p in zip(sites, knots, degrees)]
    net = np.linalg.solve(matrices[0], points.reshape(poles[0], -1)).reshape(points.shape)
    net = np.linalg.solve(matrices[1], net.transpose(1, 0, 2).reshape(poles[1], -1))
    net = net.reshape(poles[1], poles[0], 3).transpose(1, 0, 2)
    distinct = [np.unique(k, return_counts=True) for k in knots]
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(
        [[FreeCAD.Vector(*pole) for pole in row] for row in net],
        [int(m) for m in distinct[0][1]],
        [int(m) for m in distinct[1][1]],
        [float(k) for k in distinct[0][0]],
        [float(k) for k in distinct[1][0]],
        False,
        False,
        *degrees,
    )
    return surface


def vector2d(point: Sequence[float]) -> "FreeCAD.Base.Vector2d":
    """A point of the parameter plane."""
    return FreeCAD.Base.Vector2d(float(point[0]), float(point[1]))


def segment(start: Sequence[float], end: Sequence[float]) -> "Part.Geom2d.Line2dSegment":
    """Straight trimming curve from start to end in the parameter plane."""
    return Part.Geom2d.Line2dSegment(vector2d(start), vector2d(end))


def bezier(*poles: Sequence[float]) -> "Part.Geom2d.BezierCurve2d":
    """Bezier trimming curve with the given poles in the parameter plane."""
    curve = Part.Geom2d.BezierCurve2d()
    curve.setPoles([vector2d(pole) for pole in poles])
    return curve


def ellipse(centre: Sequence[float], radii: Sequence[float]) -> "Part.Geom2d.Ellipse2d":
    """Full ellipse in the parameter plane with half axes radii = (along u, along v)."""
    ends = [vector2d((centre[0] + radii[0], centre[1])), vector2d((centre[0], centre[1] + radii[1]))]
    if radii[1] > radii[0]:
        ends.reverse()  # the kernel wants the major axis first
    return Part.Geom2d.Ellipse2d(ends[0], ends[1], vector2d(centre))


def ellipse_arcs(centre: Sequence[float], radii: Sequence[float], count: int) -> List["Part.Geom2d.Curve2d"]:
    """The same ellipse as count arcs of equal parameter length, end to end."""
    stops = np.linspace(0.0, 2.0 * np.pi, count + 1)
    whole = ellipse(centre, radii)
    return [Part.Geom2d.ArcOfEllipse2d(whole, float(a), float(b)) for a, b in zip(stops, stops[1:])]


def winding(loop: Sequence["Part.Geom2d.Curve2d"]) -> float:
    """Signed area of a closed loop in the parameter plane (positive: anticlockwise), by sampling."""
    points = []
    for curve in loop:
        for t in np.linspace(curve.FirstParameter, curve.LastParameter, 33)[:-1]:
            point = curve.value(float(t))
            points.append((point.x, point.y))
    x, y = np.array(points).T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def oriented_wire(
    surface: Part.BSplineSurface, loop: Sequence["Part.Geom2d.Curve2d"], anticlockwise: bool
) -> Part.Wire:
    """The loop's edges on the surface as one closed wire of the wanted sense."""
    wire = Part.Wire([curve.toShape(surface) for curve in loop])
    if not wire.isClosed():
        raise RuntimeError("a trimming loop does not close; let each curve start where the one before it ends")
    if (winding(loop) > 0.0) != anticlockwise:
        wire.reverse()
    return wire


def trimmed_face(surface: Part.BSplineSurface, loops: Sequence[Sequence["Part.Geom2d.Curve2d"]]) -> Part.Face:
    """Face on surface bounded by loops of parameter-plane curves, the outer loop first.

    Each curve of a loop starts where the one before it ends. Every edge keeps its curve as its pcurve. The outer
    loop is laid anticlockwise and the others clockwise, whatever their sense in the list.
    """
    face = Part.Face(oriented_wire(surface, loops[0], True))
    if len(loops) > 1:
        face.cutHoles([oriented_wire(surface, loop, False) for loop in loops[1:]])
    if not face.isValid() or len(face.Wires) != len(loops):
        raise RuntimeError("the generated face is not valid; check that the loops do not cross")
    return face


def write_step(face: Part.Face, path: str, name: str) -> None:
    """Writes the face as STEP (mm) with a fixed time stamp, so that the same face gives the same text."""
    temporary = path + ".part.step"
    face.exportStep(temporary)
    with open(temporary, encoding="utf-8") as stream:
        text = stream.read()
    text = re.sub(r"FILE_NAME\('[^']*','[^']*'", "FILE_NAME('%s','%s'" % (name, TIME_STAMP), text, count=1)
    text = re.sub(r"'Open CASCADE STEP (translator|processor) [^']*'", "'%s'" % name, text)
    with open(temporary, "w", encoding="utf-8", newline="\n") as stream:
        stream.write(text)
    os.replace(temporary, path)


def default_path(script: str, name: str) -> str:
    """Where the example's STEP file is stored: the folder above the generators."""
    return os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(script))), name + ".step")


def run(script: str, name: str, make: Callable[[], Part.Face], arguments: Sequence[str]) -> str:
    """What every generator's main does: make the face, write it, say what was written; returns the path."""
    if len(arguments) > 1:
        raise SystemExit("usage: %s [OUT.step]" % os.path.basename(script))
    path = arguments[0] if arguments else default_path(script, name)
    face = make()
    write_step(face, path, name)
    print(
        "%s: %d loops, %d edges, %.0f mm diagonal, %.0f mm2"
        % (path, len(face.Wires), len(face.Edges), face.optimalBoundingBox().DiagonalLength, face.Area)
    )
    return path
