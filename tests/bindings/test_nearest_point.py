# SPDX-License-Identifier: LGPL-2.1-or-later
"""lo.nearest_point: arrays in and out, against closed forms and OpenCASCADE's distances."""

import FreeCAD
import laminate_offset as lo
import numpy
import Part
import pytest
import sample_shapes


def random_points(face, count: int, seed: int = 1) -> numpy.ndarray:
    """Points in the face's bounding box made three times as large."""
    box = face.BoundBox
    low = numpy.array([box.XMin, box.YMin, box.ZMin]) - box.DiagonalLength
    high = numpy.array([box.XMax, box.YMax, box.ZMax]) + box.DiagonalLength
    return numpy.random.default_rng(seed).uniform(low, high, (count, 3))


def check_consistent(face, points: numpy.ndarray, found) -> None:
    """Parameters, points and distances are those of one point of the face's surface."""
    assert found.uv.shape == (len(points), 2) and found.points.shape == points.shape
    assert found.distance.shape == (len(points),)
    assert numpy.allclose(numpy.linalg.norm(found.points - points, axis=1), found.distance, atol=1e-9)
    for (u, v), point in zip(found.uv, found.points):
        assert (face.valueAt(u, v) - FreeCAD.Vector(*point)).Length < 1e-9


@pytest.mark.parametrize("place", [lambda face: face, sample_shapes.moved, sample_shapes.reversed_face])
def test_free_form_against_the_distance_of_part(place) -> None:
    face = place(sample_shapes.bspline_face())
    points = random_points(face, 40)
    found = lo.nearest_point(face, points)
    check_consistent(face, points, found)
    for point, distance in zip(points, found.distance):
        assert distance == pytest.approx(Part.Vertex(*point).distToShape(face)[0], abs=1e-7)


def test_a_sphere_with_its_poles_seam_and_centre() -> None:
    face = sample_shapes.sphere_face(10.0)
    points = numpy.vstack([random_points(face, 200), [[0, 0, 30], [0, 0, -3], [12, 0, 0], [12, -1e-9, 0], [0, 0, 0]]])
    found = lo.nearest_point(face, points)
    check_consistent(face, points, found)
    assert numpy.allclose(found.distance, abs(numpy.linalg.norm(points, axis=1) - 10.0), atol=1e-10)


def test_the_trimmed_face_and_its_edges() -> None:
    face = sample_shapes.trimmed_bspline_face()
    points = random_points(face, 60)
    points[0] = face.Surface.value(0.5, 0.5)  # in the middle of the hole
    points = numpy.ascontiguousarray(points)
    trimmed = lo.nearest_point(face, points, trimmed=True)
    check_consistent(face, points, trimmed)
    for point, distance in zip(points, trimmed.distance):
        assert distance == pytest.approx(Part.Vertex(*point).distToShape(face)[0], abs=1e-5)
    assert trimmed.distance[0] > 10.0 and lo.nearest_point(face, points[:1]).distance[0] < 1e-9


def test_no_points_and_lists_of_rows() -> None:
    face = sample_shapes.plane_face()
    assert lo.nearest_point(face, numpy.empty((0, 3))).uv.shape == (0, 2)
    found = lo.nearest_point(face, [[1, 2, 5]])
    assert found.distance == pytest.approx([5.0]) and found.points[0] == pytest.approx([1, 2, 0])


def test_bad_arguments() -> None:
    face = sample_shapes.plane_face()
    for points in ([1.0, 2.0, 3.0], numpy.zeros((2, 2)), [[0.0, float("nan"), 0.0]]):
        with pytest.raises(ValueError):
            lo.nearest_point(face, points)
    with pytest.raises(TypeError):
        lo.nearest_point(3.0, [[0, 0, 0]])
    with pytest.raises(lo.OffsetError) as refused:
        lo.nearest_point(Part.makeBox(1, 1, 1), [[0, 0, 0]])
    assert refused.value.status == "not-a-face"
