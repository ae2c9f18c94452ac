# SPDX-License-Identifier: LGPL-2.1-or-later
"""lo.stack_plies and `laminate-offset plies`: surfaces, figures, refusals and exit codes."""

import json
import math
from pathlib import Path

import FreeCAD
import laminate_offset as lo
import Part
import pytest
import sample_shapes
from laminate_offset import cli, files

TOLERANCE = 1e-3


def layup(text: str = "[0/45/-45/90]s", thickness: float = 0.125) -> lo.Layup:
    return lo.layup_from_notation(text, material="tape", thickness=thickness)


def gap(lower: "Part.Face", upper: "Part.Face", thickness: float) -> float:
    """Largest difference between the thickness and the distance from one face's inner points to the other face."""
    u0, u1, v0, v1 = lower.ParameterRange
    worst = 0.0
    for i in range(1, 6):
        for j in range(1, 6):
            u, v = u0 + (u1 - u0) * i / 6.0, v0 + (v1 - v0) * j / 6.0
            if not lower.isPartOfDomain(u, v):
                continue
            point = lower.valueAt(u, v)
            worst = max(worst, abs(upper.distToShape(Part.Vertex(point))[0] - thickness))
    return worst


@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_plies_of_a_free_form_face_lie_one_thickness_apart(direction: str) -> None:
    face = sample_shapes.trimmed_bspline_face()
    stack = lo.stack_plies(face, layup(), TOLERANCE, direction)
    assert len(stack.plies) == 8 and stack.report["one_fit"] and stack.report["plies"] == 8
    assert stack.report["thickness"] == pytest.approx(1.0)
    assert stack.report["certified_error"] <= TOLERANCE and stack.report["edge_error"] <= TOLERANCE
    sign = 1.0 if direction == "normal" else -1.0
    for number, ply in enumerate(stack.plies, start=1):
        assert ply.face.isValid() and len(ply.face.Wires) == len(face.Wires)
        assert ply.ply.number == number and ply.report.distance == pytest.approx(sign * 0.125 * number)
        assert ply.face is ply.top_face
    for lower, upper in zip(stack.plies, stack.plies[1:]):
        assert lower.top_face is upper.bottom_face
    assert gap(stack.plies[2].bottom_face, stack.plies[2].top_face, 0.125) <= 2.0 * TOLERANCE


def test_each_surface_is_that_of_offset_face() -> None:
    face = sample_shapes.bspline_face()
    for surface in ("bottom", "middle", "top"):
        stack = lo.stack_plies(face, layup("[0/90]"), TOLERANCE, surface=surface)
        for ply in stack.plies:
            distance = getattr(ply.ply, surface)
            assert ply.report.distance == distance
            single = lo.offset_face(face, distance, TOLERANCE).face
            assert gap(ply.face, single, 0.0) <= 2.0 * TOLERANCE


def test_analytic_bases_stay_analytic() -> None:
    stack = lo.stack_plies(sample_shapes.cylinder_face(10.0), layup("[0/90]2", 0.25))
    assert [ply.face.Surface.Radius for ply in stack.plies] == pytest.approx([10.25, 10.5, 10.75, 11.0])


def test_the_forms() -> None:
    stack = lo.stack_plies(sample_shapes.bspline_face(), layup("[0/90]"))
    values = json.loads(stack.to_json())
    assert values["status"] == "ok" and [ply["angle"] for ply in values["stack"]] == [0.0, 90.0]
    assert values["stack"][1]["report"]["distance"] == 0.25
    assert stack.to_shape().ShapeType == "Compound" and len(stack.to_shape().Faces) == 2
    assert stack.top_face is stack.plies[1].top_face and stack.bottom_face is stack.plies[0].bottom_face
    assert "2 plies" in stack.summary()


def bottle() -> "Part.Face":
    """The side of a bottle with a throat of 4 mm between walls that are parallel there."""
    wall = [(2.0, height) for height in range(60, 24, -6)] + [(2.6, 24.0), (5.0, 18.5)]
    turns = [math.pi * (0.85 - 0.1 * step) for step in range(9)]
    wall += [(12.0 * math.sin(turn), 5.0 - 12.0 * math.cos(turn)) for turn in turns]
    points = [*wall, (0.0, -7.0), *((-x, y) for x, y in wall[::-1])]
    profile = Part.BSplineCurve()
    profile.interpolate([FreeCAD.Vector(x, y, 0.0) for x, y in points])
    return profile.toShape().extrude(FreeCAD.Vector(0.0, 0.0, 30.0)).Faces[0]


def test_plies_that_meet_across_a_throat_are_refused() -> None:
    def plies(*thicknesses: float) -> lo.Layup:
        return lo.Layup(tuple(lo.Ply(f"P{t}", "tape", t) for t in thicknesses), direction="reversed")

    assert len(lo.stack_plies(bottle(), plies(0.5, 1.0)).plies) == 2
    with pytest.raises(
        lo.OffsetError, match="meets that of the place .*; lay fewer or thinner plies, or split"
    ) as refused:
        lo.stack_plies(bottle(), plies(1.0, 2.0))
    assert (refused.value.status, refused.value.stage) == ("self-intersection", "surface")
    where = refused.value.where
    assert where is not None and abs(where["x"]) < 3.0 + 1e-6 and where["y"] > 17.0
    with pytest.raises(lo.OffsetError, match="meets that of the place .*; use a smaller distance, or split") as refused:
        lo.offset_face(bottle(), -3.0)
    assert (refused.value.status, refused.value.stage) == ("self-intersection", "surface")


def test_a_stack_past_the_limit_is_refused() -> None:
    with pytest.raises(lo.OffsetError) as refused:
        lo.stack_plies(sample_shapes.cylinder_face(10.0), layup("[0/90]8", 1.0), direction="reversed")
    assert refused.value.status == "curvature-limit"
    assert refused.value.feasible_range[0] == pytest.approx(-10.0, abs=1e-6)


def test_bad_arguments() -> None:
    face = sample_shapes.bspline_face()
    with pytest.raises(ValueError, match="surface must be one of bottom, middle, top"):
        lo.stack_plies(face, layup(), surface="side")
    with pytest.raises(lo.LayupError, match="direction"):
        lo.stack_plies(face, layup(), direction="up")
    with pytest.raises(ValueError, match="tolerance"):
        lo.stack_plies(face, layup(), tolerance=0.0)
    bounded = lo.Layup((lo.Ply("P1", "tape", 0.1), lo.Ply("P2", "tape", 0.1, boundary="Sketch")))
    with pytest.raises(lo.LayupError, match="ply 2, boundary"):
        lo.stack_plies(face, bounded)
    with pytest.raises(lo.LayupError, match="active"):
        lo.stack_plies(face, lo.Layup((lo.Ply("P1", "tape", 0.1, active=False),)))


def test_progress_rises_and_cancels() -> None:
    seen = []
    lo.stack_plies(sample_shapes.bspline_face(), layup(), progress=lambda fraction: seen.append(fraction))
    assert seen and all(0.0 <= fraction <= 1.0 for fraction in seen)
    with pytest.raises(lo.OffsetError) as refused:
        lo.stack_plies(sample_shapes.bspline_face(), layup(), progress=lambda fraction: False)
    assert refused.value.status == "cancelled"


def test_the_command_writes_one_face_for_each_ply(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table = tmp_path / "base.brep", tmp_path / "layup.csv"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\nP2,tape,0.3,90\n", encoding="utf-8")
    output, report = tmp_path / "plies.brep", tmp_path / "plies.json"
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(output)]
    assert cli.main(arguments + ["--report", str(report)]) == 0
    assert len(files.read_faces(str(output))) == 2
    values = json.loads(report.read_text(encoding="utf-8"))
    assert [ply["top"] for ply in values["stack"]] == [0.2, 0.5] and values["thickness"] == 0.5
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,thick,0\n", encoding="utf-8")
    output.unlink()
    assert cli.main(arguments) == 2 and not output.exists()
    assert "row 2" in capfd.readouterr().err
