# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces for the tests, and a check of an offset by its definition with OpenCASCADE's own distances (through Part)."""

import math
from typing import Any, List

import FreeCAD
import Part

Vector = FreeCAD.Vector


def cylinder_face(radius: float = 10.0, height: float = 20.0) -> Any:
    """The lateral face of a cylinder; its outward normal points away from the axis."""
    return _face_of_type(Part.makeCylinder(radius, height), "Part::GeomCylinder")


def sphere_face(radius: float = 10.0) -> Any:
    """A whole sphere as one face, with a seam and two degenerate edges."""
    return Part.makeSphere(radius).Faces[0]


def plane_face() -> Any:
    """A square with a round hole."""
    square = Part.makePlane(30.0, 30.0)
    hole = Part.Wire(Part.makeCircle(5.0, Vector(15.0, 15.0, 0.0)))
    return Part.makeFace([square.OuterWire, hole], "Part::FaceMakerBullseye")


def bspline_face(size: float = 100.0, count: int = 7) -> Any:
    """An untrimmed doubly curved bicubic face; its smallest radius of curvature is some 90 mm."""
    points = [[_wave(size, i / (count - 1), j / (count - 1)) for j in range(count)] for i in range(count)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape()


def roof_face(half_width: float = 20.0, length: float = 50.0) -> Any:
    """Two planes as one B-spline face with a ridge of 90 degrees along x; its outward normal points upwards."""
    roof = Part.BSplineSurface()
    poles = [[Vector(x, y, -abs(y)) for y in (-half_width, 0.0, half_width)] for x in (0.0, length)]
    roof.buildFromPolesMultsKnots(poles, [2, 2], [2, 1, 2], [0.0, 1.0], [0.0, 0.5, 1.0], False, False, 1, 1)
    return roof.toShape()


def trimmed_bspline_face() -> Any:
    """The doubly curved face with a round hole through it: two loops."""
    drill = Part.makeCylinder(15.0, 200.0, Vector(50.0, 50.0, -100.0))
    return bspline_face().cut(drill).Faces[0]


def heavy_face() -> Any:
    """A face whose offset at a tight tolerance takes long enough to watch it."""
    return bspline_face(count=60)


def moved(face: Any) -> Any:
    """The face at another place, turned."""
    copy = face.copy()
    copy.Placement = FreeCAD.Placement(Vector(100.0, -20.0, 7.0), FreeCAD.Rotation(Vector(1.0, 2.0, 3.0), 40.0))
    return copy


def reversed_face(face: Any) -> Any:
    """The same face with the opposite orientation."""
    copy = face.copy()
    copy.reverse()
    return copy


def deviation(base: Any, offset: Any, distance: float, count: int = 12) -> float:
    """The largest distance from base point + distance * outward normal to the offset face, at points inside the loops.

    normalAt follows the face's orientation, so this is the definition of the result.
    """
    points = [base.valueAt(u, v) + base.normalAt(u, v) * distance for u, v in _inside(base, count)]
    assert len(points) > count, "too few points lie inside the loops for the check to mean anything"
    return max(Part.Vertex(point).distToShape(offset)[0] for point in points)


def edge_deviation(base: Any, offset: Any, distance: float, count: int = 7) -> float:
    """How far the offset's edges are from lying at |distance| from the base face; the worst of their points.

    The side is checked by `deviation`: this looks at the edges' own curves only.
    """
    worst, checked = 0.0, 0
    for edge in offset.Edges:
        if edge.Degenerated:
            continue
        first, last = edge.ParameterRange
        for step in range(count):
            point = edge.valueAt(first + (last - first) * step / (count - 1))
            worst = max(worst, abs(Part.Vertex(point).distToShape(base)[0] - abs(distance)))
            checked += 1
    assert checked >= count
    return worst


def largest_difference(first: Any, second: Any) -> float:
    """The largest distance between the poles of two B-spline faces that have the same number of them."""
    rows = list(zip(first.Surface.getPoles(), second.Surface.getPoles()))
    assert len(rows) == first.Surface.NbUPoles == second.Surface.NbUPoles
    assert first.Surface.NbVPoles == second.Surface.NbVPoles
    return max((a - b).Length for row, other in rows for a, b in zip(row, other))


def _inside(face: Any, count: int) -> List[Any]:
    first_u, last_u, first_v, last_v = face.ParameterRange
    steps = [(i + 0.5) / count for i in range(count)]
    grid = [(first_u + (last_u - first_u) * a, first_v + (last_v - first_v) * b) for a in steps for b in steps]
    return [(u, v) for u, v in grid if face.isPartOfDomain(u, v)]


def _wave(size: float, a: float, b: float) -> Any:
    return Vector(size * a, size * b, 8.0 * math.sin(math.pi * a) * math.cos(math.pi * b))


def _face_of_type(shape: Any, type_id: str) -> Any:
    return next(face for face in shape.Faces if face.Surface.TypeId == type_id)
