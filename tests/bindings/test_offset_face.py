# SPDX-License-Identifier: LGPL-2.1-or-later
"""offset_face: right by the definition of an offset, for every kind of face, sign, orientation and placement."""

import copy
import json
import math
import pickle

import FreeCAD
import laminate_offset as lo
import Part
import pytest
import sample_shapes
from FreeCAD import Units

TOLERANCE = 1e-3

FACES = {
    "cylinder": sample_shapes.cylinder_face,
    "sphere": sample_shapes.sphere_face,
    "plane with hole": sample_shapes.plane_face,
    "bspline": sample_shapes.bspline_face,
    "bspline with hole": sample_shapes.trimmed_bspline_face,
}
VARIANTS = {
    "as made": lambda face: face,
    "reversed": sample_shapes.reversed_face,
    "moved": sample_shapes.moved,
    "moved and reversed": lambda face: sample_shapes.moved(sample_shapes.reversed_face(face)),
}

REPORT_FIELDS = [
    "status",
    "stage",
    "message",
    "where",
    "method",
    "distance",
    "tolerance",
    "certified_error",
    "sampled_error",
    "edge_error",
    "surface",
    "limits",
    "limits_proven",
    "self_intersection",
    "loops",
    "edges",
    "faces",
    "gap",
    "crease",
    "elapsed_ms",
]


@pytest.mark.parametrize("distance", [2.0, -2.0])
@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("kind", FACES)
def test_the_result_is_the_offset_by_definition(kind: str, variant: str, distance: float) -> None:
    base = VARIANTS[variant](FACES[kind]())
    result = lo.offset_face(base, distance, TOLERANCE)
    face = result.face
    assert isinstance(face, Part.Face) and face.isValid()
    assert sample_shapes.deviation(base, face, distance) <= TOLERANCE
    assert sample_shapes.edge_deviation(base, face, distance) <= TOLERANCE
    assert face.Orientation == base.Orientation
    assert len(face.Wires) == len(base.Wires) == result.report.loops
    assert len(face.Edges) == len(base.Edges)
    middle = [sum(face.ParameterRange[i : i + 2]) / 2 for i in (0, 2)]
    foot = base.Surface.parameter(face.valueAt(*middle))
    assert face.normalAt(*middle).dot(base.normalAt(*foot)) > 0.999


def test_reversing_the_face_turns_the_sign() -> None:
    base = sample_shapes.cylinder_face(10.0)
    assert lo.offset_face(base, 2.0).face.Surface.Radius == pytest.approx(12.0, abs=1e-12)
    assert lo.offset_face(base, -2.0).face.Surface.Radius == pytest.approx(8.0, abs=1e-12)
    inside_out = sample_shapes.reversed_face(base)
    assert lo.offset_face(inside_out, 2.0).face.Surface.Radius == pytest.approx(8.0, abs=1e-12)


def test_a_free_form_result_is_a_true_bspline() -> None:
    result = lo.offset_face(sample_shapes.trimmed_bspline_face(), 3.0, TOLERANCE)
    surface = result.face.Surface
    assert surface.TypeId == "Part::GeomBSplineSurface"
    described = result.report.surface
    assert described.type == "bspline"
    assert (described.poles_u, described.poles_v) == (surface.NbUPoles, surface.NbVPoles)
    assert (described.degree_u, described.degree_v) == (surface.UDegree, surface.VDegree)


def test_a_tighter_tolerance_is_kept() -> None:
    base = sample_shapes.bspline_face()
    loose, tight = (lo.offset_face(base, 5.0, tolerance) for tolerance in (1e-1, 1e-5))
    assert sample_shapes.deviation(base, loose.face, 5.0) <= 1e-1
    assert sample_shapes.deviation(base, tight.face, 5.0) <= 1e-5
    assert loose.report.surface.poles_u < tight.report.surface.poles_u


def test_the_base_face_is_left_as_it_was() -> None:
    base = sample_shapes.moved(sample_shapes.trimmed_bspline_face())
    before = base.exportBrepToString()
    first = lo.offset_face(base, 2.0).face.exportBrepToString()
    assert base.exportBrepToString() == before
    base.tessellate(0.1)
    assert lo.offset_face(base, 2.0).face.exportBrepToString() == first


def test_the_report_has_every_field_and_survives_json() -> None:
    result = lo.offset_face(sample_shapes.trimmed_bspline_face(), -1.5, 2e-3)
    report = result.report
    assert [name for name in report.to_dict() if name in REPORT_FIELDS] == REPORT_FIELDS
    assert json.loads(report.to_json()) == report.to_dict()
    assert lo.OffsetReport.from_json(report.to_json()) == report
    assert report.status == "ok" and report["status"] == "ok" and report.where is None
    assert (report.method, report.distance, report.tolerance) == ("same-parameter", -1.5, 2e-3)
    assert report.loops == 2 and report.edges == len(result.face.Edges)
    assert report.elapsed_ms.total > 0.0
    assert report.certified_error is not None or report.sampled_error is not None
    for figure in (report.certified_error, report.sampled_error):
        assert figure is None or 0.0 <= figure <= 2e-3


def test_a_report_is_read_only_and_can_be_copied() -> None:
    report = lo.offset_face(sample_shapes.sphere_face(), 1.0).report
    report.to_dict()["status"] = "changed"
    report.surface.to_dict()["type"] = "changed"
    assert report.status == "ok" and report.surface.type == "sphere"
    with pytest.raises(TypeError):
        report["status"] = "changed"
    with pytest.raises(AttributeError, match="no field 'tolerence'"):
        report.tolerence
    for twin in (copy.deepcopy(report), pickle.loads(pickle.dumps(report))):
        assert twin == report and twin.surface.type == "sphere"
    assert {"status", "elapsed_ms", "to_json"} <= set(dir(report))


def test_lengths_may_be_freecad_quantities() -> None:
    base = sample_shapes.cylinder_face(10.0)
    result = lo.offset_face(base, Units.Quantity("0.2 cm"), Units.Quantity("10 um"))
    assert result.face.Surface.Radius == pytest.approx(12.0, abs=1e-12)
    assert result.report.tolerance == pytest.approx(0.01)
    for wrong in ("2 kg", "2 mm^2", "2 deg", "2"):
        with pytest.raises(ValueError, match="distance must be a length"):
            lo.offset_face(base, Units.Quantity(wrong))
    with pytest.raises(ValueError, match="tolerance must be a length"):
        lo.offset_face(base, 1.0, Units.Quantity("1 s"))
    with pytest.raises(TypeError, match="distance.*'2 mm'"):
        lo.offset_face(base, "2 mm")


@pytest.mark.parametrize(
    "arguments,word",
    [
        ({"distance": math.nan}, "distance"),
        ({"distance": math.inf}, "distance"),
        ({"distance": 1.0, "tolerance": 0.0}, "tolerance"),
        ({"distance": 1.0, "tolerance": -1e-3}, "tolerance"),
        ({"distance": 1.0, "tolerance": math.nan}, "tolerance"),
        ({"distance": 1.0, "method": "guess"}, "same-parameter.*ravi-kumar"),
        ({"distance": 1.0, "extension": -1.0}, "extension"),
        ({"distance": 1.0, "max_degree": 1}, "max_degree"),
        ({"distance": 1.0, "max_degree": 99}, "max_degree"),
    ],
)
def test_bad_arguments_are_value_errors(arguments, word: str) -> None:
    with pytest.raises(ValueError, match=word):
        lo.offset_face(sample_shapes.sphere_face(), **arguments)


@pytest.mark.parametrize("thing", [None, 3, "face", FreeCAD.Vector(1, 2, 3), Part.Plane(), [1]])
def test_things_that_are_no_shape_are_type_errors(thing) -> None:
    with pytest.raises(TypeError, match=f"Part.Face is needed, not {type(thing).__name__}"):
        lo.offset_face(thing, 1.0)


@pytest.mark.parametrize("empty", [Part.Shape, Part.Face])
def test_a_null_shape_is_refused(empty) -> None:
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(empty(), 1.0)
    assert (caught.value.status, caught.value.stage) == ("null-shape", "input")


@pytest.mark.parametrize("kind", ["Solids", "Shells", "Wires", "Edges", "Vertexes"])
def test_a_shape_that_is_no_face_is_refused(kind: str) -> None:
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(getattr(Part.makeBox(1.0, 2.0, 3.0), kind)[0], 1.0)
    assert (caught.value.status, caught.value.stage) == ("not-a-face", "input")


def test_a_refusal_says_why_where_and_what_would_work() -> None:
    base = sample_shapes.cylinder_face(10.0)
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(base, -12.0, 2e-3)
    error = caught.value
    assert (error.status, error.report.status) == ("curvature-limit", "curvature-limit")
    assert error.stage == error.report.stage and error.stage in ("analysis", "surface")
    assert error.message and error.message in str(error) and error.status in str(error)
    negative, positive = error.feasible_range
    assert negative == pytest.approx(-10.0, abs=1e-6) and positive is None
    assert set(error.where) == {"u", "v", "x", "y", "z"}
    assert math.hypot(error.where["x"], error.where["y"]) == pytest.approx(10.0, abs=1e-9)
    place = base.valueAt(error.where["u"], error.where["v"])
    assert tuple(place) == pytest.approx([error.where[axis] for axis in "xyz"], abs=1e-9)
    assert (error.report.distance, error.report.tolerance) == (-12.0, 2e-3)
    assert error.report.limits.to_dict() == {"negative": negative, "positive": None}
    assert "Feasible distances" in str(error) and "any positive one" in str(error)


def test_a_refusal_can_be_sent_to_another_process() -> None:
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(sample_shapes.cylinder_face(10.0), -12.0)
    twin = pickle.loads(pickle.dumps(caught.value))
    assert type(twin) is lo.OffsetError and str(twin) == str(caught.value)
    assert twin.where == caught.value.where and twin.feasible_range == caught.value.feasible_range
    assert twin.report == caught.value.report


def test_a_bspline_past_its_curvature_is_refused_inside_its_range() -> None:
    base = sample_shapes.bspline_face()
    with pytest.raises(lo.OffsetError) as caught:
        lo.offset_face(base, 1000.0)
    error = caught.value
    assert error.status == "curvature-limit" and error.where is not None
    limit = error.feasible_range[1]
    assert 50.0 < limit < 1000.0
    assert lo.offset_face(base, 0.9 * limit, 1e-2).face.isValid()


def test_distance_zero_gives_the_face_itself() -> None:
    base = sample_shapes.trimmed_bspline_face()
    result = lo.offset_face(base, 0.0)
    assert sample_shapes.deviation(base, result.face, 0.0) <= TOLERANCE
    assert result.face.Area == pytest.approx(base.Area, rel=1e-6)


@pytest.mark.parametrize("distance, crease", [(3.0, "gap"), (-3.0, "overlap")])
def test_a_creased_face_becomes_a_shell(distance: float, crease: str) -> None:
    result = lo.offset_face(sample_shapes.roof_face(), distance)
    assert isinstance(result.shape, Part.Shell) and result.face is result.shape
    assert len(result.shape.Faces) == 2 and all(face.isValid() for face in result.shape.Faces)
    report = result.report
    assert (report.faces, report.crease, report.loops, report.edges) == (2, crease, 1, 4)
    assert report.gap == pytest.approx(abs(distance) * math.sqrt(2.0), rel=0.01)
    assert report.certified_error <= TOLERANCE and "2 faces along creases" in report.summary()
    middle = result.shape.BoundBox.Center
    assert middle.z == pytest.approx(-10.0 + distance / math.sqrt(2.0), abs=abs(distance) * 0.5 + TOLERANCE)


def test_a_smooth_face_stays_a_face() -> None:
    result = lo.offset_face(sample_shapes.bspline_face(), 2.0)
    assert isinstance(result.shape, Part.Face) and result.face is result.shape
    assert (result.report.faces, result.report.gap, result.report.crease) == (1, None, None)
