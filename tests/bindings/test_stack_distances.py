# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sixteen plies of 0.125 mm on large panels with openings: neighbours keep their distance everywhere, all is valid."""

import math
from pathlib import Path
from typing import Any, Iterator, List

import laminate_offset as lo
import numpy
import pytest
from conftest import PROJECT
from laminate_offset import files

PANEL = PROJECT / "resources" / "examples" / "panel_two_holes.step"
FUSELAGE = "derived_D150_fuselage_2p3m_1hole_6curves.step"
THICKNESS, TOLERANCE, PLIES = 0.125, 1e-3, 16


def places(face: Any, count: int) -> Iterator[Any]:
    """Parameters inside the loops: random ones, and ones beside every edge."""
    random = numpy.random.default_rng(7)
    u0, u1, v0, v1 = face.ParameterRange
    found = 0
    while found < count:
        u, v = random.uniform(u0, u1), random.uniform(v0, v1)
        if face.isPartOfDomain(u, v):
            found += 1
            yield u, v
    for edge in face.Edges:
        curve, first, last = face.curveOnSurface(edge)
        for t in random.uniform(first, last, 8):
            point = curve.value(t)
            yield point.x, point.y


def off_normal(surface: Any, u: float, v: float, point: Any) -> float:
    """Sine of the angle between the surface's normal and the way from a point to the surface's place."""
    way = surface.value(u, v) - point
    return way.cross(surface.normal(u, v)).Length / way.Length


def distances(lower: Any, upper: Any, uv: List[Any]) -> Iterator[float]:
    """From points of one surface to the nearest points of the next: OpenCASCADE's projection."""
    for u, v in uv:
        point = lower.Surface.value(u, v)
        foot = upper.Surface.parameter(point)
        assert off_normal(upper.Surface, *foot, point) < 1e-3
        yield (upper.Surface.value(*foot) - point).Length


@pytest.mark.parametrize("which", ["panel", "fuselage"])
def test_neighbours_keep_their_distance(which: str, request: pytest.FixtureRequest) -> None:
    path = PANEL if which == "panel" else request.getfixturevalue("data_dir") / FUSELAGE
    (face,) = files.read_faces(str(Path(path)))
    layup = lo.Layup(tuple(lo.Ply(f"P{i}", "tape", THICKNESS, 45.0 * (i % 4)) for i in range(1, PLIES + 1)))
    stack = lo.stack_plies(face, layup, TOLERANCE, solids=True)
    assert len(stack.plies) == PLIES and stack.report["certified_error"] <= TOLERANCE
    loops, edges = len(face.Wires), len(face.Edges)
    for ply in stack.plies:
        for side in (ply.bottom_face, ply.top_face):
            assert side.isValid() and (len(side.Wires), len(side.Edges)) == (loops, edges)
        assert ply.solid.isValid() and ply.solid.isClosed() and ply.solid.Volume > 0.0
    uv = list(places(face, 24))
    assert len(uv) == 24 + 8 * edges
    worst, count = 0.0, 0
    for ply in stack.plies:
        for distance in distances(ply.bottom_face, ply.top_face, uv):
            worst, count = max(worst, abs(distance - THICKNESS)), count + 1
    assert count == PLIES * len(uv) and worst <= TOLERANCE
    # and all of them together stand where they should
    for (u, v), distance in zip(uv, distances(face, stack.top_face, uv)):
        assert math.isclose(distance, PLIES * THICKNESS, abs_tol=TOLERANCE), (u, v)
