# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real lay-up and fuselage surfaces through the command line, checked by the definition of an offset."""

import json
from pathlib import Path

import laminate_offset as lo
import pytest
import sample_shapes
from laminate_offset import files

FUSELAGE = "derived_D150_fuselage_2p3m_1hole_6curves.step"
MOULD = "psas_nose_mold.igs"


@pytest.mark.parametrize("distance", [5.0, -5.0, 227.0])
def test_a_fuselage_skin_with_a_hole(command_line, data_dir: Path, tmp_path: Path, distance: float) -> None:
    source = data_dir / FUSELAGE
    run = command_line(
        "offset", source, "--face", 1, "--distance", distance, "--tolerance", 0.001, "--report", "r.json"
    )
    assert run.returncode == 0, run.stderr
    (base,), (face,) = files.read_faces(str(source)), files.read_faces(str(tmp_path / (source.stem + "_offset.step")))
    assert face.isValid()
    assert face.Surface.TypeId == "Part::GeomBSplineSurface"
    assert (len(face.Wires), len(face.Edges)) == (2, 6)
    assert sample_shapes.deviation(base, face, distance) <= 0.001
    report = json.loads((tmp_path / "r.json").read_text())
    assert (report["status"], report["loops"], report["edges"]) == ("ok", 2, 6)


def test_a_nose_mould_face_by_face(command_line, data_dir: Path, tmp_path: Path) -> None:
    source = data_dir / MOULD
    run = command_line("offset", source, "--face", "all", "--distance", 1, "-o", "out.brep", "--report", "r.json")
    bases = files.read_faces(str(source))
    reports = json.loads((tmp_path / "r.json").read_text())
    assert [report["face"] for report in reports] == list(range(1, len(bases) + 1))
    done = [number for number, report in enumerate(reports) if report["status"] == "ok"]
    assert run.returncode == (0 if len(done) == len(bases) else 1)
    assert len(done) >= len(bases) // 2
    results = files.read_faces(str(tmp_path / "out.brep"))
    assert len(results) == len(done)
    for number, face in zip(done, results):
        assert face.isValid(), number + 1
        assert sample_shapes.deviation(bases[number], face, 1.0) <= 0.001, number + 1
    for report in reports:
        assert report["status"] == "ok" or (report["message"] and f"face {report['face']} refused" in run.stderr)


@pytest.mark.parametrize("direction", ["normal", "reversed"])
def test_eight_plies_on_a_nose_mould_face_by_face(data_dir: Path, direction: str) -> None:
    layup = lo.layup_from_notation("[0/45/-45/90]s", "IM7-8552-134")
    made = 0
    for number, face in enumerate(files.read_faces(str(data_dir / MOULD)), start=1):
        stack = lo.stack_plies(face, layup, direction=direction, solids=True)
        assert stack.report["certified_error"] is None or stack.report["certified_error"] <= 1e-3, number
        figures = stack.mass_properties()
        for ply, figure in zip(stack.plies, figures.plies):
            assert ply.face.isValid() and ply.solid.isValid() and ply.solid.isClosed(), number
            assert ply.solid.Volume == pytest.approx(figure.volume, abs=2e-3 * figure.area), number
        made += 1
    assert made == 59
