# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how far an offset face is from the exact offset of its base, with OpenCASCADE's projections alone.

Nothing of LaminateOffset takes part, so the figures check its reports. Surface and edges are sampled both ways: points
of the result against the base, and points of the exact offset S + d N of the base against the result. All lengths are
in mm.

Usage: measure_offset.py BASE RESULT DISTANCE [--grid N] [--edge-points N]

BASE and RESULT are STEP, IGES or BREP files with one face each, with the same edges in the same order.
"""

import argparse
import os
import sys
from dataclasses import asdict, dataclass
from typing import Callable, Iterator, List, Sequence, Tuple

import numpy as np

FREECAD_LIBRARY_FOLDERS = ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/lib64/freecad/lib")
sys.path += [folder for folder in FREECAD_LIBRARY_FOLDERS if os.path.isdir(folder) and folder not in sys.path]

import FreeCAD  # noqa: E402  (must come before Part and after the path above)
import Part  # noqa: E402

CURVE_SAMPLES = 400  # along an exact offset edge; the nearest place is then refined between its neighbours
GOLDEN = 0.5 * (5.0**0.5 - 1.0)
HALVINGS = 40


@dataclass(frozen=True)
class Measured:
    """Largest deviations found, in mm, and how many places were compared."""

    surface_to_base: float  # | distance of the result's points to the base - |d| |
    base_to_surface: float  # distance of exact offset points to the result's surface
    edges_to_base: float  # distance of the result's edges to the exact offset of the base's edges
    base_to_edges: float  # distance of the exact offset of the base's edges to the result's edges
    normals: float  # least cosine between the result's normal and the base's at the nearest point
    points: int  # of both surfaces
    edge_points: int  # of both sets of edges

    @property
    def worst(self) -> float:
        """The largest of the four deviations."""
        return max(self.surface_to_base, self.base_to_surface, self.edges_to_base, self.base_to_edges)


def inner_parameters(face: Part.Face, count: int) -> Iterator[Tuple[float, float]]:
    """Parameters inside the loops, from a grid of count x count over the face's range that is not aligned with knots."""
    u0, u1, v0, v1 = face.ParameterRange
    for i in range(count):
        for j in range(count):
            u = u0 + (u1 - u0) * (i + 0.5 + 0.2 * (j % 3 - 1)) / count
            v = v0 + (v1 - v0) * (j + 0.5 + 0.2 * (i % 3 - 1)) / count
            if face.isPartOfDomain(u, v):
                yield u, v


def foot_on(face: Part.Face, point: "FreeCAD.Vector") -> "FreeCAD.Vector":
    """The nearest point of the face's surface."""
    try:
        return face.Surface.projectPoint(point, "NearestPoint")
    except RuntimeError:  # no foot of a perpendicular: the nearest point lies on the end of the surface
        return Part.Vertex(point).distToShape(face.Surface.toShape())[1][0][1]


def normal_at(face: Part.Face, u: float, v: float) -> "FreeCAD.Vector":
    """The unit outward normal, the face's orientation included."""
    return face.normalAt(u, v).normalize()


def result_against_base(base: Part.Face, result: Part.Face, distance: float, grid: int) -> Tuple[float, float, int]:
    """Deviation, least cosine and count of the result's points seen from the base."""
    worst, cosine, count = 0.0, 1.0, 0
    for u, v in inner_parameters(result, grid):
        point = result.Surface.value(u, v)
        foot = foot_on(base, point)
        away = point - foot
        worst = max(worst, abs(away.Length - abs(distance)))
        if distance != 0.0:
            along = away * (1.0 / (distance * away.Length / abs(distance)))
            cosine = min(cosine, along.dot(normal_at(result, u, v)))
        count += 1
    return worst, cosine, count


def base_against_result(base: Part.Face, result: Part.Face, distance: float, grid: int) -> Tuple[float, int]:
    """Deviation and count of the base's exact offset points seen from the result."""
    worst, count = 0.0, 0
    for u, v in inner_parameters(base, grid):
        exact = base.Surface.value(u, v) + normal_at(base, u, v) * distance
        worst = max(worst, exact.distanceToPoint(foot_on(result, exact)))
        count += 1
    return worst, count


def exact_edge(base: Part.Face, edge: Part.Edge, distance: float) -> Tuple[Callable, float, float]:
    """The exact offset of an edge of the base as a function of its parameter, with its range."""
    pcurve, first, last = base.curveOnSurface(edge)

    def point(t: float) -> "FreeCAD.Vector":
        place = pcurve.value(t)
        return base.Surface.value(place.x, place.y) + normal_at(base, place.x, place.y) * distance

    return point, first, last


def nearest_on(curve: Callable, parameters: Sequence[float], samples: np.ndarray, point: "FreeCAD.Vector") -> float:
    """Distance of a point to a curve with known samples: the nearest sample, then a golden section beside it."""
    k = int(np.argmin(np.linalg.norm(samples - np.array(tuple(point)), axis=1)))
    low, high = parameters[max(k - 1, 0)], parameters[min(k + 1, len(parameters) - 1)]
    for _ in range(HALVINGS):
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        if curve(a).distanceToPoint(point) < curve(b).distanceToPoint(point):
            high = b
        else:
            low = a
    return min(curve(t).distanceToPoint(point) for t in (low, high, parameters[k]))


def edge_deviations(base: Part.Face, result: Part.Face, distance: float, edge_points: int) -> Tuple[float, float, int]:
    """Deviations of the result's edges from the exact ones, and of the exact ones from the result's; count."""
    if len(base.Edges) != len(result.Edges):
        raise ValueError("base and result have %d and %d edges" % (len(base.Edges), len(result.Edges)))
    to_base, to_edges, count = 0.0, 0.0, 0
    for base_edge, edge in zip(base.Edges, result.Edges):
        if edge.Degenerated:
            continue
        curve, first, last = exact_edge(base, base_edge, distance)
        parameters = np.linspace(first, last, CURVE_SAMPLES + 1)
        samples = np.array([tuple(curve(t)) for t in parameters])
        for t in np.linspace(*edge.ParameterRange, edge_points):
            to_base = max(to_base, nearest_on(curve, parameters, samples, edge.valueAt(float(t))))
        for t in np.linspace(first, last, edge_points):
            to_edges = max(to_edges, Part.Vertex(curve(t)).distToShape(edge)[0])
        count += 2 * edge_points
    return to_base, to_edges, count


def measure(base: Part.Face, result: Part.Face, distance: float, grid: int = 30, edge_points: int = 60) -> Measured:
    """Compares an offset with its base; distance [mm] is signed along the base's outward normal."""
    to_base, cosine, points = result_against_base(base, result, distance, grid)
    to_surface, exact_points = base_against_result(base, result, distance, grid)
    edges_to_base, to_edges, along_edges = edge_deviations(base, result, distance, edge_points)
    if not points or not exact_points:
        raise ValueError("no place of the grid lies inside the loops; take a finer one")
    return Measured(to_base, to_surface, edges_to_base, to_edges, cosine, points + exact_points, along_edges)


def only_face(path: str) -> Part.Face:
    """The one face of a file."""
    faces: List[Part.Face] = Part.read(path).Faces
    if len(faces) != 1:
        raise ValueError("%s holds %d faces; one is needed" % (path, len(faces)))
    return faces[0]


def main(arguments: Sequence[str]) -> int:
    """Runs the command; returns its exit code."""
    parser = argparse.ArgumentParser(description="Deviation of an offset face from the exact offset of its base.")
    parser.add_argument("base")
    parser.add_argument("result")
    parser.add_argument("distance", type=float, help="signed along the base's outward normal [mm]")
    parser.add_argument("--grid", type=int, default=30, help="points in each direction")
    parser.add_argument("--edge-points", type=int, default=60, help="points along each edge")
    options = parser.parse_args(arguments)
    faces = only_face(options.base), only_face(options.result)
    measured = measure(*faces, options.distance, options.grid, options.edge_points)
    for name, value in asdict(measured).items():
        print("%-16s %.6g" % (name, value))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
