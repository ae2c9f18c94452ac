# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stored examples are what their generators make, and are what they say."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from example_tools import EXAMPLES, run_script

sys.path.insert(0, str(EXAMPLES / "generators"))

import naca_wing_skin  # noqa: E402
import panel_boundaries  # noqa: E402
import panel_two_holes  # noqa: E402
import table1_duct  # noqa: E402
import table1_fairing  # noqa: E402
import table1_rib  # noqa: E402
import trimmed_face  # noqa: E402
import wigley_hull  # noqa: E402

import FreeCAD  # noqa: E402  (trimmed_face has found FreeCAD's libraries)
import Part  # noqa: E402

# name: loops, edges, degrees and poles of the surface
EXPECTED = {
    "naca_wing_skin": (2, 6, (3, 3), (14, 6)),
    "panel_two_holes": (3, 9, (3, 3), (9, 7)),
    "table1_duct": (2, 6, (3, 3), (9, 10)),
    "table1_fairing": (3, 9, (3, 3), (11, 8)),
    "table1_rib": (3, 24, (1, 1), (2, 2)),
    "wigley_hull": (2, 6, (2, 2), (3, 3)),
}


def only_face(path: Path) -> Part.Face:
    shape = Part.read(str(path))
    assert len(shape.Faces) == 1
    return shape.Faces[0]


def stored(name: str) -> Part.Face:
    return only_face(EXAMPLES / (name + ".step"))


@pytest.fixture(params=sorted(EXPECTED))
def name(request) -> str:
    return request.param


def test_every_generator_is_expected_here():
    scripts = {path.stem for path in (EXAMPLES / "generators").glob("*.py")} - {"trimmed_face", "panel_boundaries"}
    assert scripts == set(EXPECTED)
    assert {path.stem for path in EXAMPLES.glob("*.step")} == set(EXPECTED)


def test_stored_example_is_the_valid_trimmed_face_it_claims_to_be(name):
    face = stored(name)
    loops, edges, degrees, poles = EXPECTED[name]
    assert face.isValid()
    assert (len(face.Wires), len(face.Edges)) == (loops, edges)
    surface = face.Surface
    assert isinstance(surface, Part.BSplineSurface)
    assert (surface.UDegree, surface.VDegree) == degrees
    assert (surface.NbUPoles, surface.NbVPoles) == poles
    assert all(face.curveOnSurface(edge) is not None for edge in face.Edges)
    assert max(edge.Tolerance for edge in face.Edges) < 1e-4
    assert face.Area < 0.999 * surface.toShape().Area, "the face must be trimmed"


def test_generator_makes_the_stored_example_again(name, tmp_path):
    again = tmp_path / "again.step"
    output = run_script(EXAMPLES / "generators" / (name + ".py"), [str(again)], tmp_path)
    assert str(again) in output
    assert [path.name for path in tmp_path.iterdir()] == ["again.step"]
    made, kept = only_face(again), stored(name)
    assert made.Area == pytest.approx(kept.Area, rel=1e-9)
    assert made.Orientation == kept.Orientation
    net, kept_net = (np.array([[tuple(p) for p in row] for row in f.Surface.getPoles()]) for f in (made, kept))
    np.testing.assert_allclose(net, kept_net, atol=1e-8)
    np.testing.assert_allclose(made.Surface.getUKnots(), kept.Surface.getUKnots())
    for edge, kept_edge in zip(made.Edges, kept.Edges):
        assert edge.Length == pytest.approx(kept_edge.Length, rel=1e-7)
        for vertex, kept_vertex in zip(edge.Vertexes, kept_edge.Vertexes):
            assert vertex.Point.distanceToPoint(kept_vertex.Point) < 1e-6


def test_generator_writes_the_same_text_twice(name, tmp_path):
    texts = []
    for run_number in range(2):
        path = tmp_path / ("%d.step" % run_number)
        run_script(EXAMPLES / "generators" / (name + ".py"), [str(path)], tmp_path)
        texts.append(path.read_text(encoding="utf-8"))
    assert texts[0] == texts[1]
    assert trimmed_face.TIME_STAMP in texts[0]


def largest_departure(surface, formula) -> float:
    u0, u1, v0, v1 = surface.bounds()
    grid = [(u, v) for u in np.linspace(u0, u1, 60) for v in np.linspace(v0, v1, 40)]
    return max(math.dist(surface.value(u, v), formula(u, v)) for u, v in grid)


@pytest.mark.parametrize(
    "name, formula, bound",
    [
        ("naca_wing_skin", naca_wing_skin.skin, 0.1),
        ("panel_two_holes", panel_two_holes.barrel, 0.1),
        ("table1_duct", table1_duct.duct, 0.1),
        ("table1_fairing", table1_fairing.fairing, 0.1),
        ("table1_rib", table1_rib.plane, 1e-9),
        ("wigley_hull", wigley_hull.hull, 1e-9),
    ],
)
def test_surface_follows_its_formula(name, formula, bound):
    assert largest_departure(stored(name).Surface, formula) < bound


def principal_curvatures(face) -> np.ndarray:
    """Both principal curvatures along the outward normal at grid points inside the loops."""
    u0, u1, v0, v1 = face.ParameterRange
    grid = [(u, v) for u in np.linspace(u0, u1, 50) for v in np.linspace(v0, v1, 50) if face.isPartOfDomain(u, v)]
    sign = -1.0 if face.Orientation == "Reversed" else 1.0
    assert len(grid) > 1000
    values = [[face.Surface.curvature(u, v, kind) for kind in ("Min", "Max")] for u, v in grid]
    return sign * np.array(values)


@pytest.mark.parametrize(
    "name, diagonal, slack",
    [
        ("panel_two_holes", 3430.0, 60.0),
        ("table1_fairing", 3430.0, 2.0),
        ("table1_duct", 2270.0, 2.0),
        ("table1_rib", 1040.0, 2.0),
    ],
)
def test_faces_of_the_papers_table_have_its_sizes_and_can_be_offset_by_a_tenth_of_them(name, diagonal, slack):
    face = stored(name)
    assert face.optimalBoundingBox().DiagonalLength == pytest.approx(diagonal, abs=slack)
    for distance in (0.1 * diagonal, -0.1 * diagonal):
        assert (1.0 - distance * principal_curvatures(face)).min() > 0.5


def test_free_form_faces_of_the_papers_table_are_doubly_curved():
    fairing, duct = (np.prod(principal_curvatures(stored(name)), axis=1) for name in ("table1_fairing", "table1_duct"))
    assert fairing.min() < -1e-7 and fairing.max() > 1e-7, "parts like a saddle and parts like a dome"
    assert duct.min() > 1e-7


def test_wing_skin_keeps_clear_of_the_nose():
    assert (1.0 + 10.0 * principal_curvatures(stored("naca_wing_skin"))).min() > 0.5


def test_hull_normal_points_into_the_water():
    face = stored("wigley_hull")
    u0, u1, v0, v1 = face.ParameterRange
    assert face.normalAt(0.5 * (u0 + u1), 0.5 * (v0 + v1)).y > 0.5


def test_the_stored_boundary_of_a_pad_is_the_generators():
    panel = stored("panel_two_holes")
    document = FreeCAD.openDocument(str(EXAMPLES / "panel_boundaries.FCStd"), True)
    try:
        (kept,) = [thing.Shape.copy() for thing in document.Objects if thing.Label == panel_boundaries.LABEL]
    finally:
        FreeCAD.closeDocument(document.Name)
    made = panel_boundaries.contour(panel)
    assert kept.isClosed() and kept.Length == pytest.approx(made.Length, rel=1e-9)
    assert kept.distToShape(made)[0] < 1e-7
    assert all(edge.distToShape(panel)[0] < 1e-6 for edge in kept.Edges)
    assert panel_boundaries.LABEL in (EXAMPLES / "layup_inactive_ply.csv").read_text(encoding="utf-8")
