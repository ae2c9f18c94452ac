# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces extended past their sides, through Python and the command line."""

import json
from pathlib import Path

import FreeCAD
import Part
import pytest

import laminate_offset as lo


def plate_with_hole() -> "Part.Face":
    plate = Part.makePlane(30, 20).cut(Part.makeCylinder(3, 10, FreeCAD.Vector(15, 10, -5)))
    return plate.Faces[0]


def test_grows_a_plate_and_keeps_its_hole() -> None:
    face = plate_with_hole()
    result = lo.extend_face(face, 5.0)
    assert result.face.isValid()
    assert len(result.face.Wires) == 2
    assert result.face.Area - face.Area == pytest.approx(40 * 30 - 30 * 20, rel=1e-9)
    assert [side["side"] for side in result.report.sides] == ["u-min", "u-max", "v-min", "v-max"]
    for side in result.report.sides:
        assert side["mean_length"] == pytest.approx(5.0)
        assert side["join_angle"] < 1e-9
    assert json.loads(result.report.to_json()) == result.report.to_dict()


@pytest.mark.parametrize("sides", ["u-max, v-min", ["u-max", "v-min"], ("U-MAX", "V-MIN")])
def test_takes_sides_as_text_or_list(sides: object) -> None:
    result = lo.extend_face(Part.makePlane(30, 20).Faces[0], FreeCAD.Units.Quantity("2 mm"), sides)  # type: ignore
    assert result.face.Area == pytest.approx(32 * 22)


@pytest.mark.parametrize("continuity", ["G1", "natural"])
@pytest.mark.parametrize("rule", ["mean", "at-least"])
def test_extends_a_spline_tube_along_its_axis(continuity: str, rule: str) -> None:
    tube = Part.makeCylinder(10, 30).toNurbs().Faces[0]
    result = lo.extend_face(tube, 5.0, "v-min,v-max", continuity, rule)
    assert result.face.isValid()
    assert result.face.BoundBox.ZLength == pytest.approx(40.0, abs=1e-6)
    assert result.report.continuity == continuity
    assert result.report.rule == rule


def test_refuses_a_closed_side_with_place_and_report() -> None:
    with pytest.raises(lo.OffsetError) as caught:
        lo.extend_face(Part.makeCylinder(10, 30).Faces[0], 5.0)
    assert caught.value.status == "self-intersection"
    assert caught.value.stage == "extension"
    assert caught.value.where is not None
    assert caught.value.report.length == 5.0
    assert caught.value.report.sides == []


@pytest.mark.parametrize(
    "arguments", [{"length": -1.0}, {"sides": "left"}, {"sides": []}, {"continuity": "C7"}, {"rule": "most"}]
)
def test_refuses_bad_arguments(arguments: dict) -> None:  # type: ignore[type-arg]
    with pytest.raises(ValueError):
        lo.extend_face(Part.makePlane(3, 2).Faces[0], **{"length": 1.0, **arguments})


def test_offset_face_extends_its_result() -> None:
    result = lo.offset_face(plate_with_hole(), 2.0, extension=3.0)
    assert result.face.isValid()
    assert len(result.face.Wires) == 2
    assert result.report.extension.length == 3.0
    assert result.face.BoundBox.XLength == pytest.approx(36.0)
    assert lo.offset_face(plate_with_hole(), 2.0).report.extension is None


def test_the_papers_route_extends_the_surface_and_keeps_the_loops() -> None:
    wavy = [[FreeCAD.Vector(50 * i, 40 * j, (i - 2) ** 2 - (j - 1) ** 2) for j in range(4)] for i in range(5)]
    surface = Part.BSplineSurface()
    surface.interpolate(wavy)
    plain, wider = (lo.offset_face(surface.toShape(), -5.0, 1e-2, "ravi-kumar", extension) for extension in (0, 20.0))
    assert wider.face.isValid() and len(wider.face.Edges) == 4
    assert plain.report.extension is None
    assert [side["moved_edges"] for side in wider.report.extension.sides] == [0, 0, 0, 0]
    assert wider.face.Area == pytest.approx(plain.face.Area, rel=1e-4)
    assert wider.face.Surface.toShape().Area > 1.2 * wider.face.Area
    assert wider.report.certified_error <= 1e-2 and wider.report.edge_error <= 1e-2


def test_command_line(command_line, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    source, output, report = (tmp_path / name for name in ("in.brep", "out.brep", "report.json"))
    Part.makePlane(30, 20).exportBrep(str(source))
    arguments = ["extend", source, "--face", "1", "--length", "4", "-o", output]
    run = command_line(*arguments, "--sides", "u-min", "--report", report)
    assert run.returncode == 0, run.stderr
    shape = Part.Shape()
    shape.read(str(output))
    assert shape.Area == pytest.approx(34 * 20)
    written = json.loads(report.read_text(encoding="utf-8"))
    assert written["face"] == 1 and written["status"] == "ok" and written["sides"][0]["side"] == "u-min"
    assert command_line(*arguments, "--sides", "left").returncode == 2
    Part.makeCylinder(10, 30).exportBrep(str(source))
    run = command_line("extend", source, "--face", "1", "--length", "4", "-o", output)
    assert run.returncode == 1
    assert "closed" in run.stderr
