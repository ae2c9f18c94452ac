# SPDX-License-Identifier: LGPL-2.1-or-later
"""lo.project_curve: wires on faces, their pcurves and figures."""

import FreeCAD
import laminate_offset as lo
import Part
import pytest
import sample_shapes

Vector = FreeCAD.Vector


def check_on_face(face, projection, bound: float) -> None:
    """Every edge runs along its pcurve within the bound."""
    assert projection.wire.Edges and len(projection.pcurves) == len(projection.wire.Edges) == len(projection.edges)
    for edge, (pcurve, first, last) in zip(projection.wire.Edges, projection.pcurves):
        for step in range(21):
            t = first + (last - first) * step / 20
            uv = pcurve.value(t)
            assert (edge.valueAt(t) - face.valueAt(uv.x, uv.y)).Length <= bound + 1e-9


@pytest.mark.parametrize("place", [lambda face: face, sample_shapes.moved, sample_shapes.reversed_face])
def test_edges_go_back_onto_their_own_face(place) -> None:
    face = place(sample_shapes.trimmed_bspline_face())
    for edge in face.Edges:
        projection = lo.project_curve(face, edge)
        assert projection.certified_error is not None and projection.certified_error <= 1e-3
        assert all(part["on_surface"] for part in projection.edges)
        check_on_face(face, projection, projection.certified_error)
        assert sum(e.Length for e in projection.wire.Edges) == pytest.approx(edge.Length, rel=1e-6)


def test_a_ply_boundary_above_the_face_is_dropped() -> None:
    face = sample_shapes.bspline_face()
    circle = Part.Wire(Part.makeCircle(20.0, Vector(50.0, 50.0, 40.0)))
    projection = lo.project_curve(face, circle, tolerance=1e-2)
    assert projection.wire.ShapeType == "Wire" and projection.wire.isClosed()
    assert projection.certified_error <= 1e-2 and not projection.edges[0]["on_surface"]
    assert 30.0 < projection.distance < 50.0
    assert projection.distance <= projection.certified_distance <= 1.2 * projection.distance
    assert projection.edges[0]["certified_distance"] == projection.certified_distance
    assert projection.edges[0]["bridged"] is False
    check_on_face(face, projection, projection.certified_error)
    for point in projection.wire.discretize(15):  # the normal there meets the given circle
        u, v = face.Surface.parameter(point)
        normal = Part.makeLine(point, point + face.normalAt(u, v) * 100.0)
        assert normal.distToShape(circle)[0] < 2e-2


def test_a_curve_across_the_seam_is_split() -> None:
    face = sample_shapes.cylinder_face(10.0, 20.0)
    line = Part.makeLine(Vector(12.0, -5.0, 4.0), Vector(12.0, 5.0, 9.0))
    projection = lo.project_curve(face, line)
    assert len(projection.wire.Edges) == 2 and projection.wire.ShapeType == "Wire"
    check_on_face(face, projection, projection.certified_error)


def test_parts_outside_are_clipped_or_the_surface_goes_on() -> None:
    face = sample_shapes.cylinder_face(10.0, 20.0)
    line = Part.makeLine(Vector(-12.0, 1.0, -10.0), Vector(-12.0, 2.0, 30.0))
    clipped = lo.project_curve(face, line)
    extended = lo.project_curve(face, line, outside="extend")
    assert clipped.wire.BoundBox.ZMin == pytest.approx(0.0, abs=2e-3)
    assert clipped.wire.BoundBox.ZMax == pytest.approx(20.0, abs=2e-3)
    assert extended.wire.BoundBox.ZMin == pytest.approx(-10.0, abs=1e-2)
    assert extended.wire.BoundBox.ZMax == pytest.approx(30.0, abs=1e-2)


def test_refusals() -> None:
    face = sample_shapes.bspline_face()
    edge = face.Edges[0]
    with pytest.raises(ValueError):
        lo.project_curve(face, edge, tolerance=0.0)
    with pytest.raises(ValueError):
        lo.project_curve(face, edge, outside="somewhere")
    with pytest.raises(TypeError):
        lo.project_curve(face, 1.0)
    with pytest.raises(lo.OffsetError) as refused:
        lo.project_curve(face, Part.makeLine(Vector(900, 0, 0), Vector(900, 10, 0)))
    assert refused.value.status == "not-supported" and "inside" in str(refused.value)
    with pytest.raises(lo.OffsetError) as refused:
        lo.project_curve(face, face)
    assert refused.value.status == "not-supported"
