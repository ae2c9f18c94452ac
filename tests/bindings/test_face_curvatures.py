# SPDX-License-Identifier: LGPL-2.1-or-later
"""Principal curvatures of faces, against closed forms, FreeCAD's own, and folded offsets."""

import FreeCAD as App
import numpy
import Part
import pytest
from laminate_offset import _core


def places(face, count=5):
    """Parameters inside the ranges of a face, not on its sides."""
    u0, u1, v0, v1 = face.ParameterRange
    shares = (numpy.arange(count) + 0.37) / count
    return numpy.array([(u0 + a * (u1 - u0), v0 + b * (v1 - v0)) for a in shares for b in shares])


def wavy():
    surface = Part.BSplineSurface()
    heights = [[0, 3, 1, 4], [2, 5, 0, 1], [1, 0, 4, 2], [3, 2, 5, 0]]
    surface.interpolate([[App.Vector(20 * i, 20 * j, heights[i][j]) for j in range(4)] for i in range(4)])
    return surface.toShape()


@pytest.mark.parametrize("radius", [1e-3, 10.0, 1e6])
def test_sphere_and_cylinder(radius):
    ball = Part.makeSphere(radius).Faces[0]
    assert numpy.allclose(_core.face_curvatures(ball, places(ball)) * radius, -1.0)
    can = Part.makeCylinder(radius, radius).Faces[0]
    assert numpy.allclose(_core.face_curvatures(can, places(can)) * radius, [[-1.0, 0.0]] * 25)
    inner = can.reversed()
    assert numpy.allclose(_core.face_curvatures(inner, places(inner)) * radius, [[0.0, 1.0]] * 25)


def test_pole_of_a_sphere_has_the_curvature_beside_it():
    ball = Part.makeSphere(10.0).Faces[0]
    u0, u1, v0, v1 = ball.ParameterRange
    poles = numpy.array([(0.5 * (u0 + u1), v0), (0.5 * (u0 + u1), v1)])
    assert numpy.allclose(_core.face_curvatures(ball, poles), -0.1)


@pytest.mark.parametrize("turned", [False, True])
def test_free_form_agrees_with_freecad(turned):
    face = wavy()
    if turned:
        face.reverse()
    face.Placement = App.Placement(App.Vector(5, -7, 9), App.Rotation(App.Vector(1, 2, 3), 40))
    uv = places(face)
    found = _core.face_curvatures(face, uv)
    # FreeCAD's are along S_u x S_v, positive where the surface bends towards it, whatever the face's orientation.
    theirs = numpy.array([sorted(face.Surface.curvature(u, v, way) for way in ("Min", "Max")) for u, v in uv])
    outward = _core.evaluate_face(face, uv)[1]
    du = numpy.array([numpy.cross(*(tuple(d) for d in face.Surface.tangent(u, v))) for u, v in uv])
    sign = numpy.sign(
        (du * [tuple(face.Placement.Rotation.inverted().multVec(App.Vector(*n))) for n in outward]).sum(1)
    )
    expected = numpy.where(sign[:, None] > 0, theirs, -theirs[:, ::-1])
    assert numpy.ptp(found) > 1e-2 and (found[:, 0] <= found[:, 1]).all()
    assert numpy.abs(found - expected).max() < 1e-9


@pytest.mark.parametrize("distance", [4.0, -4.0])
def test_offsets_stretch_as_the_curvatures_say(distance):
    face = wavy()
    uv = places(face)
    lowest, highest = _core.face_curvatures(face, uv).T
    points, normals, _ = _core.evaluate_face(face, uv)
    step = 1e-4
    grids = [_core.evaluate_face(face, uv + shift) for shift in ((step, 0), (-step, 0), (0, step), (0, -step))]

    def area(d):
        a, b, c, e = (p + d * n for p, n, _ in grids)
        return (numpy.cross(a - b, c - e) * normals).sum(axis=1)

    stretch = area(distance) / area(0.0)
    assert numpy.allclose(stretch, (1 - distance * lowest) * (1 - distance * highest), rtol=1e-5, atol=1e-6)
    assert numpy.ptp(stretch) > 0.1 and len(points) == 25


def test_face_at_a_distance_from_its_surface():
    face = wavy()
    uv = places(face)
    near = _core.face_curvatures(face, uv)
    for distance in (3.0, -3.0):
        moved = Part.OffsetSurface(face.Surface, distance).toShape()
        found = _core.face_curvatures(moved, uv)
        side = numpy.sign(
            (
                (_core.evaluate_face(moved, uv)[0] - _core.evaluate_face(face, uv)[0])
                * _core.evaluate_face(face, uv)[1]
            ).sum(axis=1)
        )
        assert (side == side[0]).all()
        expected = near / (1 - side[0] * abs(distance) * near)
        assert numpy.allclose(found, numpy.sort(expected, axis=1), rtol=1e-6, atol=1e-9)


def test_wrong_arguments_are_told():
    ball = Part.makeSphere(10.0).Faces[0]
    with pytest.raises(ValueError, match="shape"):
        _core.face_curvatures(ball, numpy.zeros((3, 3)))
    with pytest.raises(ValueError, match="finite"):
        _core.face_curvatures(ball, numpy.array([[numpy.nan, 0.0]]))
    with pytest.raises(TypeError):
        _core.face_curvatures(3, numpy.zeros((1, 2)))
    assert _core.face_curvatures(ball, numpy.zeros((0, 2))).shape == (0, 2)
