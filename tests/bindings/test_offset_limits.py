# SPDX-License-Identifier: LGPL-2.1-or-later
"""lo.offset_limits and `laminate-offset limits`: figures, forms and exit codes."""

import json
import os
from pathlib import Path

import FreeCAD
import laminate_offset as lo
import Part
import pytest
import sample_shapes
from laminate_offset import files

PLACE = {"u", "v", "x", "y", "z"}
KEYS = ["status", "stage", "message", "where", "proven", "negative", "positive"]


def test_a_cylinder_in_any_position_has_its_radius() -> None:
    for face in (sample_shapes.cylinder_face(10.0), sample_shapes.moved(sample_shapes.cylinder_face(10.0))):
        limits = lo.offset_limits(face)
        assert limits.negative == pytest.approx(-10.0, abs=1e-9) and limits.positive is None
        assert set(limits.where_negative) == PLACE and limits.where_positive is None
        place = limits.where_negative
        assert (face.valueAt(place["u"], place["v"]) - FreeCAD.Vector(*(place[k] for k in "xyz"))).Length < 1e-9
        assert limits.proven
        turned = lo.offset_limits(sample_shapes.reversed_face(face))
        assert turned.negative is None and turned.positive == pytest.approx(10.0, abs=1e-9)


def test_a_plane_has_no_limits() -> None:
    limits = lo.offset_limits(sample_shapes.plane_face())
    assert (limits.negative, limits.positive, limits.where_negative, limits.where_positive) == (None,) * 4
    assert "any negative one" in limits.summary() and "any positive one" in limits.summary()


def test_the_limits_of_a_free_form_face_are_those_of_its_offset() -> None:
    face = sample_shapes.bspline_face()
    limits = lo.offset_limits(face)
    assert limits.negative < 0.0 < limits.positive and limits.proven
    for limit in (limits.negative, limits.positive):
        assert lo.offset_face(face, 0.9 * limit).report.status == "ok"
        with pytest.raises(lo.OffsetError) as refused:
            lo.offset_face(face, 1.01 * limit)
        assert refused.value.status == "curvature-limit"


def test_the_forms() -> None:
    limits = lo.offset_limits(sample_shapes.bspline_face())
    values = limits.to_dict()
    assert list(values) == KEYS
    assert values["status"] == "ok" and values["stage"] == "analysis" and values["where"] is None
    assert values["negative"] == {"distance": limits.negative, "where": limits.where_negative}
    assert values["positive"] == {"distance": limits.positive, "where": limits.where_positive}
    assert json.loads(limits.to_json()) == values
    values["negative"]["distance"] = 0.0
    assert limits.to_dict()["negative"]["distance"] == limits.negative


def test_what_is_no_face_is_refused() -> None:
    with pytest.raises(lo.OffsetError) as refused:
        lo.offset_limits(Part.makeBox(1, 1, 1))
    assert (refused.value.status, refused.value.stage) == ("not-a-face", "input")
    with pytest.raises(TypeError):
        lo.offset_limits(3.0)


@pytest.fixture
def rod(tmp_path: Path) -> Path:
    """A solid cylinder of radius 10."""
    path = tmp_path / "rod.brep"
    files.write_shape(Part.makeCylinder(10.0, 20.0), str(path), "rod")
    return path


def test_the_command_for_one_face(command_line, rod: Path, tmp_path: Path) -> None:
    run = command_line("limits", rod, "--face", 1, "--report", "limits.json")
    assert run.returncode == 0 and run.stderr == ""
    assert run.stdout == "face 1: feasible distances from -10 mm up to any positive one\n"
    report = json.loads((tmp_path / "limits.json").read_text())
    assert list(report) == ["face", *KEYS]
    assert report["face"] == 1 and report["negative"]["distance"] == pytest.approx(-10.0)
    assert sorted(os.listdir(tmp_path)) == ["limits.json", "rod.brep"]


def test_the_command_for_all_faces(command_line, rod: Path, tmp_path: Path) -> None:
    run = command_line("limits", rod, "--face", "all", "--report", "limits.json")
    assert run.returncode == 0
    assert len(run.stdout.splitlines()) == 3
    reports = json.loads((tmp_path / "limits.json").read_text())
    assert [report["face"] for report in reports] == [1, 2, 3]
    assert [report["negative"] is None for report in reports] == [False, True, True]


def test_a_refused_face_is_code_1(command_line, tmp_path: Path) -> None:
    files.write_shape(Part.Plane().toShape(), str(tmp_path / "endless.brep"), "endless")
    run = command_line("limits", "endless.brep", "--face", 1, "--report", "limits.json")
    assert run.returncode == 1 and run.stdout == ""
    assert "face 1 refused at input: unbounded-face" in run.stderr
    report = json.loads((tmp_path / "limits.json").read_text())
    assert report["status"] == "unbounded-face" and report["where"] is None
    assert report["negative"] is None and report["positive"] is None and report["proven"] is None


@pytest.mark.parametrize("report", ["rod.brep", "/proc/limits.json"])
def test_a_report_that_cannot_be_kept_is_code_2(command_line, rod: Path, report: str) -> None:
    before = rod.read_bytes()
    run = command_line("limits", rod, "--face", 1, "--report", report)
    assert run.returncode == 2 and "Traceback" not in run.stderr
    assert rod.read_bytes() == before


def test_bad_usage_is_code_2(command_line, rod: Path) -> None:
    assert command_line("limits", rod).returncode == 2
    assert command_line("limits", rod, "--face", 9).returncode == 2
    assert command_line("limits", "absent.step", "--face", 1).returncode == 2
