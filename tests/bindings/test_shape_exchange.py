# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every way of exchanging shapes keeps them exactly, leaks nothing, and the best one that works is taken."""

import glob
import resource

import laminate_offset as lo
import Part
import pytest
import sample_shapes
from laminate_offset import _core, exchange

FACES = {
    "trimmed": sample_shapes.trimmed_bspline_face,
    "moved": lambda: sample_shapes.moved(sample_shapes.trimmed_bspline_face()),
    "reversed": lambda: sample_shapes.reversed_face(sample_shapes.trimmed_bspline_face()),
    "moved and reversed": lambda: sample_shapes.moved(sample_shapes.reversed_face(sample_shapes.bspline_face())),
    "seam": sample_shapes.sphere_face,
}


def test_the_zero_copy_way_is_in_use_here() -> None:
    assert lo.shape_exchange() == "zero-copy"


@pytest.mark.parametrize("way", exchange.WAYS)
def test_self_test_passes(way: str) -> None:
    assert exchange.self_test(way) == ""


@pytest.mark.parametrize("kind", FACES)
@pytest.mark.parametrize("way", exchange.WAYS)
def test_a_face_comes_back_exactly(way: str, kind: str) -> None:
    face = FACES[kind]()
    back = _core.round_trip(face, way)
    assert isinstance(back, Part.Face)
    assert back.Orientation == face.Orientation
    assert back.Placement.Matrix.A == pytest.approx(face.Placement.Matrix.A, abs=1e-14)
    assert len(back.Wires) == len(face.Wires) and len(back.Edges) == len(face.Edges)
    assert [edge.Orientation for edge in back.Edges] == [edge.Orientation for edge in face.Edges]
    assert back.Area == pytest.approx(face.Area, rel=1e-12)
    if kind != "seam":
        # Poles are read with the placement applied, of which BREP text keeps 15 digits.
        rounding = 1e-12 if way == "brep-text" and "moved" in kind else 0.0
        assert sample_shapes.largest_difference(back, face) <= rounding


@pytest.mark.parametrize("way", exchange.WAYS)
def test_only_zero_copy_shares_the_shape(way: str) -> None:
    face = FACES["moved and reversed"]()
    assert _core.round_trip(face, way).isEqual(face) == (way == "zero-copy")


@pytest.mark.parametrize("shape_type", ["Solid", "Shell", "Wire", "Edge", "Vertex", "Compound"])
@pytest.mark.parametrize("way", exchange.WAYS)
def test_every_kind_of_shape_keeps_its_type(way: str, shape_type: str) -> None:
    box = Part.makeBox(1.0, 2.0, 3.0)
    shape = {
        "Solid": box,
        "Shell": box.Shells[0],
        "Wire": box.Wires[0],
        "Edge": box.Edges[0],
        "Vertex": box.Vertexes[0],
        "Compound": Part.Compound([box]),
    }[shape_type]
    assert _core.round_trip(shape, way).ShapeType == shape_type


@pytest.mark.parametrize("way", exchange.WAYS)
def test_the_offset_is_the_same_by_every_way(way: str) -> None:
    face = sample_shapes.moved(sample_shapes.reversed_face(sample_shapes.trimmed_bspline_face()))
    expected = lo.offset_face(face, 2.0).face
    _core.select_shape_exchange(way)
    try:
        assert lo.shape_exchange() == way
        result = lo.offset_face(face, 2.0).face
    finally:
        _core.select_shape_exchange("zero-copy")
    assert result.isValid()
    assert result.Orientation == expected.Orientation
    assert result.Area == pytest.approx(expected.Area, rel=1e-12)
    assert sample_shapes.deviation(face, result, 2.0) <= 1e-3


@pytest.mark.parametrize("way,times,allowed_mb", [("zero-copy", 50000, 4), ("binary", 400, 8), ("brep-text", 200, 8)])
def test_round_trips_do_not_leak(way: str, times: int, allowed_mb: int) -> None:
    face = sample_shapes.bspline_face()
    for _ in range(times // 4):
        _core.round_trip(face, way)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(times):
        _core.round_trip(face, way)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < allowed_mb * 1024


def test_binary_leaves_no_file_behind() -> None:
    before = set(glob.glob("/dev/shm/laminate_offset_*"))
    _core.round_trip(sample_shapes.bspline_face(), "binary")
    assert set(glob.glob("/dev/shm/laminate_offset_*")) == before


def test_an_unknown_way_is_a_value_error() -> None:
    with pytest.raises(ValueError, match="pigeon.*zero-copy"):
        _core.select_shape_exchange("pigeon")
    with pytest.raises(ValueError, match="null"):
        _core.round_trip(Part.Shape(), "zero-copy")


@pytest.mark.parametrize("way", exchange.WAYS)
def test_the_environment_forces_a_way(way: str, python) -> None:
    code = "import laminate_offset as lo; print(lo.shape_exchange())"
    assert python(code, LAMINATE_OFFSET_SHAPE_EXCHANGE=way).stdout.strip() == way


def test_the_environment_naming_no_way_is_an_import_error(python) -> None:
    run = python("import laminate_offset", LAMINATE_OFFSET_SHAPE_EXCHANGE="pigeon")
    assert run.returncode == 1
    assert "ImportError: LAMINATE_OFFSET_SHAPE_EXCHANGE=pigeon is not one of zero-copy" in run.stderr


def test_without_the_bridge_the_next_way_is_taken(python) -> None:
    code = (
        "import FreeCAD, Part; del Part.__toPythonOCC__\n"
        "import laminate_offset as lo; print(lo.shape_exchange())\n"
        "print(lo.offset_face(Part.makeSphere(10).Faces[0], 1.0).report.status)"
    )
    assert python(code).stdout.split() == ["binary", "ok"]


def test_another_opencascade_is_not_shared(python) -> None:
    code = (
        "import FreeCAD, Part; Part.OCC_VERSION = '1.2.3'\n"
        "import laminate_offset as lo; print(lo.shape_exchange()); print(lo.exchange.self_test('zero-copy'))"
    )
    lines = python(code).stdout.splitlines()
    assert lines[0] == "binary" and "OpenCASCADE 1.2.3" in lines[1]


def test_when_nothing_works_the_import_says_what_was_tried(python) -> None:
    run = python(
        "import FreeCAD, Part\n" "Part.OCC_VERSION = '1.2.3'; del Part.cast_to_shape\n" "import laminate_offset"
    )
    assert run.returncode == 1
    last_line = run.stderr.strip().splitlines()[-1]
    assert last_line.startswith("ImportError: No way to exchange shapes")
    assert all(f"{way}: " in last_line for way in exchange.WAYS)
