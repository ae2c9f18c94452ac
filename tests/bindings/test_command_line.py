# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line laminate-offset: what it reads, writes and prints, and its exit codes."""

import json
import os
import pty
import shutil
import signal
import subprocess
import time
from pathlib import Path

import laminate_offset as lo
import Part
import pytest
import sample_shapes
from laminate_offset import files


@pytest.fixture
def wing(tmp_path: Path) -> Path:
    """A trimmed free-form face as STEP."""
    path = tmp_path / "wing.step"
    files.write_shape(sample_shapes.trimmed_bspline_face(), str(path), "wing")
    return path


@pytest.fixture
def rod(tmp_path: Path) -> Path:
    """A solid cylinder of radius 10: its lateral face cannot go 12 inwards, its ends can."""
    path = tmp_path / "rod.brep"
    files.write_shape(Part.makeCylinder(10.0, 20.0), str(path), "rod")
    return path


def test_one_face(command_line, wing: Path, tmp_path: Path) -> None:
    run = command_line(
        "offset", wing, "--face", 1, "--distance", 5, "--tolerance", 0.002, "-o", "out.step", "--report", "report.json"
    )
    assert run.returncode == 0, run.stderr
    (base,), (face,) = files.read_faces(str(wing)), files.read_faces(str(tmp_path / "out.step"))
    assert face.Surface.TypeId == "Part::GeomBSplineSurface" and face.isValid() and len(face.Wires) == 2
    assert sample_shapes.deviation(base, face, 5.0) <= 0.002
    report = json.loads((tmp_path / "report.json").read_text())
    assert (report["face"], report["status"], report["distance"], report["tolerance"]) == (1, "ok", 5.0, 0.002)
    poles = f"{report['surface']['poles_u']} x {report['surface']['poles_v']} poles"
    assert len(run.stdout.splitlines()) == 1
    assert run.stdout.startswith("face 1: ok") and poles in run.stdout and "error" in run.stdout
    assert sorted(os.listdir(tmp_path)) == ["out.step", "report.json", "wing.step"]


@pytest.mark.parametrize(
    "source,target",
    [
        ("in.stp", "out.FCStd"),
        ("in.IGES", "out.step"),
        ("in.brp", "out.iges"),
        ("in.fcstd", "out.brep"),
        ("in.STEP", "out.STP"),
    ],
)
def test_every_format_in_and_out(command_line, source: str, target: str, tmp_path: Path) -> None:
    base = sample_shapes.moved(sample_shapes.trimmed_bspline_face())
    files.write_shape(base, str(tmp_path / source), "base")
    run = command_line("offset", source, "--face", 1, "--distance", -2, "-o", target)
    assert run.returncode == 0, run.stderr
    (read,), (face,) = files.read_faces(str(tmp_path / source)), files.read_faces(str(tmp_path / target))
    # A format may turn the face over, so the face as read is the base.
    assert sample_shapes.deviation(read, face, -2.0) <= 1.01e-3


@pytest.mark.parametrize("choice", [["--face", 1], ["--face", "all"]])
@pytest.mark.parametrize("target", ["out.step", "out.brep", "out.FCStd", "out.iges"])
def test_a_creased_face_is_written_as_its_parts(command_line, target: str, choice: list, tmp_path: Path) -> None:
    files.write_shape(sample_shapes.roof_face(), str(tmp_path / "roof.brep"), "roof")
    run = command_line("offset", "roof.brep", *choice, "--distance", 2, "-o", target, "--report", "report.json")
    assert run.returncode == 0, run.stderr
    assert "2 faces along creases" in run.stdout
    faces = files.read_faces(str(tmp_path / target))
    assert len(faces) == 2 and all(face.isValid() for face in faces)
    assert sum(face.Area for face in faces) == pytest.approx(2 * 50.0 * 20.0 * 2.0**0.5, rel=1e-4)
    content = json.loads((tmp_path / "report.json").read_text())
    report = content[0] if choice[-1] == "all" else content
    assert (report["faces"], report["crease"]) == (2, "gap") and report["gap"] > 2.8


def test_the_default_output_is_named_after_the_input(command_line, tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    files.write_shape(sample_shapes.bspline_face(), str(tmp_path / "models" / "wave.igs"), "wave")
    run = command_line("offset", "models/wave.igs", "--face", "1", "--distance", "1.5")
    assert run.returncode == 0, run.stderr
    assert sorted(os.listdir(tmp_path)) == ["models", "wave_offset.step"]
    assert os.listdir(tmp_path / "models") == ["wave.igs"]


def test_the_launcher_works_through_a_link_and_from_anywhere(launcher: Path, wing: Path, tmp_path: Path) -> None:
    link = tmp_path / "somewhere"
    link.symlink_to(launcher)
    command = [str(link), "offset", str(wing), "--face", "1", "--distance", "1", "-o", str(tmp_path / "out.brep")]
    run = subprocess.run(command, cwd="/", env={"PATH": "/usr/bin:/bin"}, capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "out.brep").is_file()


def test_the_launcher_moves_with_its_tree(launcher: Path, tmp_path: Path) -> None:
    addon = Path(lo.__file__).parents[1]
    for place in (Path("Mod"), Path("share/freecad/Mod")):
        prefix = tmp_path / place.parts[0]
        (prefix / "bin").mkdir(parents=True)
        shutil.copy(launcher, prefix / "bin")
        shutil.copytree(addon / "laminate_offset", prefix / place / "LaminateOffset" / "laminate_offset")
        command = [str(prefix / "bin" / "laminate-offset"), "--version"]
        run = subprocess.run(command, env={"PATH": "/usr/bin:/bin"}, capture_output=True, text=True, timeout=60)
        assert run.stdout.strip() == f"laminate-offset {lo.__version__}", run.stderr
    shutil.rmtree(tmp_path / "share" / "share")
    run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert run.returncode == 1 and "the add-on was not found" in run.stderr


def test_a_refused_face_is_code_1_and_keeps_the_old_output(command_line, rod: Path, tmp_path: Path) -> None:
    (tmp_path / "out.step").write_text("old")
    run = command_line("offset", rod, "--face", 1, "--distance", -12, "-o", "out.step", "--report", "report.json")
    assert run.returncode == 1
    assert run.stdout == ""
    assert "face 1 refused at" in run.stderr and "curvature-limit" in run.stderr and "Feasible distances" in run.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["status"] == "curvature-limit" and report["stage"] in ("analysis", "surface")
    assert set(report["where"]) == {"u", "v", "x", "y", "z"}
    assert report["limits"]["negative"] == pytest.approx(-10.0, abs=1e-6)
    assert (tmp_path / "out.step").read_text() == "old"


def test_all_faces_one_refused(command_line, rod: Path, tmp_path: Path) -> None:
    run = command_line("offset", rod, "--face", "all", "--distance", -12, "-o", "out.brep", "--report", "report.json")
    assert run.returncode == 1
    reports = json.loads((tmp_path / "report.json").read_text())
    assert [report["face"] for report in reports] == [1, 2, 3]
    assert [report["status"] for report in reports] == ["curvature-limit", "ok", "ok"]
    assert [line.split(":")[0] for line in run.stdout.splitlines()] == ["face 2", "face 3"]
    compound = Part.Shape()
    compound.read(str(tmp_path / "out.brep"))
    assert compound.ShapeType == "Compound"
    children, bases = compound.childShapes(), Part.makeCylinder(10.0, 20.0).Faces[1:]
    assert [child.ShapeType for child in children] == ["Face", "Face"]
    for child, base in zip(children, bases):
        assert sample_shapes.deviation(base, child, -12.0) <= 1e-3


def test_all_faces_done(command_line, rod: Path, tmp_path: Path) -> None:
    run = command_line("offset", rod, "--face", "all", "--distance", 3, "-o", "out.FCStd", "--report", "report.json")
    assert run.returncode == 0, run.stderr
    assert [report["status"] for report in json.loads((tmp_path / "report.json").read_text())] == ["ok"] * 3
    assert len(files.read_faces(str(tmp_path / "out.FCStd"))) == 3


def test_all_faces_refused_writes_no_shape(command_line, tmp_path: Path) -> None:
    files.write_shape(sample_shapes.cylinder_face(), str(tmp_path / "tube.brep"), "tube")
    run = command_line(
        "offset", "tube.brep", "--face", "all", "--distance", -10, "-o", "out.step", "--report", "r.json"
    )
    assert run.returncode == 1
    assert sorted(os.listdir(tmp_path)) == ["r.json", "tube.brep"]
    (report,) = json.loads((tmp_path / "r.json").read_text())
    assert report["status"] == "curvature-limit"


def test_a_distance_with_an_exponent_may_be_negative(command_line, rod: Path, tmp_path: Path) -> None:
    run = command_line("offset", rod, "--face", 1, "--distance", "-2e-1", "-o", "out.brep")
    assert run.returncode == 0, run.stderr
    (face,) = files.read_faces(str(tmp_path / "out.brep"))
    assert face.Surface.Radius == pytest.approx(9.8, abs=1e-12)


@pytest.mark.parametrize(
    "arguments,reason",
    [
        ([], "required: COMMAND"),
        (["offset"], "required: INPUT, --face, --distance"),
        (["offset", "rod.brep", "--face", "1"], "required: --distance"),
        (["offset", "rod.brep", "--face", "0", "--distance", "1"], "faces count from 1"),
        (["offset", "rod.brep", "--face", "-1", "--distance", "1"], "--face"),
        (["offset", "rod.brep", "--face", "one", "--distance", "1"], "neither a face number nor all"),
        (["offset", "rod.brep", "--face", "4", "--distance", "1"], "there is no face 4; it has 3"),
        (["offset", "rod.brep", "--face", "1", "--distance", "far"], "--distance"),
        (["offset", "rod.brep", "--face", "1", "--distance", "nan"], "distance is not a finite number"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--tolerance", "0"], "tolerance"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--method", "guess"], "--method"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--max-degree", "2"], "max_degree"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "-o", "out.dwg"], "'.dwg' is not a known format"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "-o", "no/out.step"], "there is no folder"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "-o", "./rod.brep"], "is the input"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--report", "rod.brep"], "is the input"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--report", "no/r.json"], "there is no folder"),
        (["offset", "rod.brep", "--face", "1", "--distance", "1", "--report", "rod_offset.step"], "also the output"),
        (["offset", "absent.step", "--face", "1", "--distance", "1"], "no such file"),
        (["offset", "junk.step", "--face", "1", "--distance", "1"], "could not be read as STEP"),
        (["offset", "junk.txt", "--face", "1", "--distance", "1"], "'.txt' is not a known format"),
    ],
)
def test_bad_usage_is_code_2_and_writes_nothing(command_line, rod: Path, tmp_path: Path, arguments, reason) -> None:
    (tmp_path / "junk.step").write_text("junk")
    (tmp_path / "junk.txt").write_text("junk")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    run = command_line(*arguments)
    assert run.returncode == 2
    assert reason in run.stderr and "Traceback" not in run.stderr
    assert run.stdout == ""
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_an_unwritable_folder_is_code_2(command_line, rod: Path) -> None:
    run = command_line("offset", rod, "--face", 1, "--distance", 1, "-o", "/proc/out.step")
    assert run.returncode == 2 and "cannot be written to" in run.stderr


def test_help_and_version(command_line) -> None:
    assert command_line("--version").stdout.strip() == f"laminate-offset {lo.__version__}"
    assert "offset" in command_line("--help").stdout
    text = " ".join(command_line("offset", "--help").stdout.split())
    for words in ("--face N|all", "mm along the face's outward normal", "default: 0.001", "default: same-parameter"):
        assert words in text


def test_without_freecad_it_says_what_to_do(launcher: Path, tmp_path: Path) -> None:
    environment = {"PATH": "/usr/bin:/bin", "FREECAD_LIB": str(tmp_path)}
    run = subprocess.run([str(launcher), "--version"], env=environment, capture_output=True, text=True, timeout=60)
    assert run.returncode == 2
    assert run.stderr.startswith("laminate-offset: laminate_offset needs FreeCAD") and "Traceback" not in run.stderr


def test_ctrl_c_writes_nothing(launcher: Path, tmp_path: Path) -> None:
    faces = [sample_shapes.heavy_face()] * 40
    files.write_shape(Part.Compound([face.copy() for face in faces]), str(tmp_path / "many.brep"), "many")
    command = [str(launcher), "offset", "many.brep", "--face", "all", "--distance", "5", "--tolerance", "1e-7"]
    command += ["-o", "out.brep", "--report", "report.json"]
    process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline().startswith("face 1: ok")
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors.strip() == "laminate-offset: cancelled; nothing was written."
    assert os.listdir(tmp_path) == ["many.brep"]


@pytest.mark.parametrize("ending", ["| true", "2>&1 | true", ">&-", "2>&-", "<&- >&- 2>&-"])
def test_results_are_written_when_nobody_reads_the_lines(
    ending: str, launcher: Path, rod: Path, tmp_path: Path
) -> None:
    command = f"{launcher} offset {rod} --face all --distance -12 -o out.brep --report report.json"
    for _attempt in range(3):  # `true` may end before the first line or after it
        done = subprocess.run(
            ["bash", "-c", f"{command} {ending}; exit ${{PIPESTATUS[0]}}"], cwd=tmp_path, capture_output=True, text=True
        )
        assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
        assert len(json.loads((tmp_path / "report.json").read_text())) == 3
        assert len(files.read_faces(str(tmp_path / "out.brep"))) == 2
        (tmp_path / "report.json").unlink()


def test_progress_is_drawn_on_a_terminal_only(launcher: Path, wing: Path, tmp_path: Path) -> None:
    pytest.importorskip("tqdm", reason="tqdm is not installed")
    controller, terminal = pty.openpty()
    command = [str(launcher), "offset", str(wing), "--face", "1", "--distance", "5", "-o", str(tmp_path / "out.brep")]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=terminal, text=True)
    os.close(terminal)
    shown = _read_terminal(controller)
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 0
    assert "offset:" in shown and "%" in shown
    assert output.startswith("face 1: ok") and "\r" not in output


def _read_terminal(controller: int) -> str:
    """What a process writes to its terminal until it ends."""
    shown = b""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            shown += os.read(controller, 4096)
        except OSError:  # the other side is closed
            break
    os.close(controller)
    return shown.decode()
