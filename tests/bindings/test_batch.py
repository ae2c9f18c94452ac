# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset batch: jobs of every kind, failures, wrong tables, resuming, Ctrl-C and killed runs."""

import csv
import json
import os
import signal
import subprocess
import time
from glob import glob
from pathlib import Path
from typing import Any, Dict, List

import FreeCAD
import pytest
import sample_shapes
from laminate_offset import files
from laminate_offset.batch import JobsError, read_jobs
from conftest import PROJECT
from sample_shapes import Part

HEADER = "input,face,distance,layup,tolerance,output\n"
LAYUP = "ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\nP2,tape,0.3,90\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with inputs: a wing, a rod whose lateral face cannot go 12 inwards, and a layup."""
    files.write_shape(sample_shapes.trimmed_bspline_face(), str(tmp_path / "wing.step"), "wing")
    files.write_shape(Part.makeCylinder(10.0, 20.0), str(tmp_path / "rod.brep"), "rod")
    (tmp_path / "layup.csv").write_text(LAYUP, encoding="utf-8")
    return tmp_path


def table(folder: Path, *rows: str, header: str = HEADER) -> Path:
    path = folder / "jobs.csv"
    path.write_text(header + "".join(f"{row}\n" for row in rows), encoding="utf-8")
    return path


def summary(folder: Path) -> List[Dict[str, str]]:
    with open(folder / "out" / "summary.csv", encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def states(folder: Path) -> List[str]:
    return [row["state"] + (" before" if row["skipped"] == "yes" else "") for row in summary(folder)]


def record(folder: Path, output: str) -> Dict[str, Any]:
    content: Dict[str, Any] = json.loads((folder / "out" / f"{output}.json").read_text(encoding="utf-8"))
    return content


def leftovers(folder: Path) -> List[str]:
    places = [Path(place) / name for place, folders, _ in os.walk(folder / "out") for name in folders]
    return [str(place) for place in places if place.name.startswith(".laminate")]


def long_jobs(folder: Path, count: int = 3) -> Path:
    """A quick job and then some that take a while."""
    heavy = Part.Compound([sample_shapes.heavy_face() for _ in range(60)])
    files.write_shape(heavy, str(folder / "many.brep"), "many")
    rows = [f"many.brep,all,{number},,1e-7,long{number}.brep" for number in range(1, count + 1)]
    return table(folder, "wing.step,1,5,,,quick.step", *rows)


def start(launcher: Path, folder: Path, *options: str) -> "subprocess.Popen[str]":
    """A batch whose first, quick job is done."""
    command = [str(launcher), "batch", "jobs.csv", "-o", "out", *options]
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "row 2: quick.step: done\n"
    return process


def children(process: int) -> List[int]:
    lists = [Path(name).read_text() for name in glob(f"/proc/{process}/task/*/children")]
    return [int(child) for text in lists for child in text.split()]


def wait_for_end(process: int) -> None:
    """Waits until a process that is not our child has ended; one that nobody has fetched yet has ended as well."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        try:
            if Path(f"/proc/{process}/stat").read_text().split(")")[-1].split()[0] == "Z":
                return
        except OSError:
            return
        time.sleep(0.05)
    raise AssertionError("the process is still there")


@pytest.mark.parametrize("workers", [1, 3])
def test_every_kind_of_job(command_line, folder: Path, workers: int) -> None:
    table(
        folder,
        "wing.step,1,5,,0.002,wing.step",
        "rod.brep,all,-3,,,deep/rod.brep",
        "wing.step,1,,layup.csv,,plies.FCStd",
    )
    run = command_line("batch", "jobs.csv", "-o", "out", "--workers", workers)
    assert run.returncode == 0, run.stderr
    assert sorted(run.stdout.splitlines()) == [
        "row 2: wing.step: done",
        "row 3: deep/rod.brep: done",
        "row 4: plies.FCStd: done",
    ]
    (base,), (face,) = files.read_faces(str(folder / "wing.step")), files.read_faces(str(folder / "out" / "wing.step"))
    assert sample_shapes.deviation(base, face, 5.0) <= 0.002
    radii = [face.Surface.Radius for face in files.read_faces(str(folder / "out/deep/rod.brep"))[:1]]
    assert radii == pytest.approx([7.0]) and len(files.read_faces(str(folder / "out" / "plies.FCStd"))) == 2
    rows = summary(folder)
    assert [row["row"] for row in rows] == ["2", "3", "4"] and [row["face"] for row in rows] == ["1", "all", "1"]
    assert states(folder) == ["done"] * 3 and [row["count"] for row in rows] == ["1", "3", "2"]
    assert 0.0 < float(rows[0]["certified_error"]) <= 0.002 and float(rows[2]["edge_error"]) <= 1e-3
    assert record(folder, "wing.step")["report"]["tolerance"] == 0.002
    assert [report["status"] for report in record(folder, "deep/rod.brep")["report"]] == ["ok"] * 3
    assert [ply["top"] for ply in record(folder, "plies.FCStd")["report"]["stack"]] == [0.2, 0.5]
    assert leftovers(folder) == []


def test_only_what_changed_is_done_again(command_line, folder: Path) -> None:
    rows = ["wing.step,1,5,,,a.step", "rod.brep,1,2,,,b.brep", "rod.brep,2,2,,,c.brep", "rod.brep,1,,layup.csv,,d.brep"]
    table(folder, *rows)
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    before = {path: path.read_bytes() for path in (folder / "out").iterdir() if path.suffix != ".csv"}
    assert len(before) == 8
    # Neither another order of the rows nor another time of the input changes a job.
    table(folder, *reversed(rows))
    os.utime(folder / "wing.step", (1, 1))
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done before"] * 4 and float(summary(folder)[3]["certified_error"]) <= 1e-3
    assert {path: path.read_bytes() for path in before} == before
    (folder / "out" / "b.brep.json").unlink()
    (folder / "out" / "c.brep").unlink()
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done before", "done", "done", "done before"]
    (folder / "layup.csv").write_text(LAYUP.replace("0.3", "0.4"), encoding="utf-8")
    table(folder, "wing.step,1,6,,,a.step", *rows[1:])
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done", "done before", "done before", "done"]
    files.write_shape(Part.makeCylinder(11.0, 20.0), str(folder / "rod.brep"), "rod")
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done before", "done", "done", "done"]


def test_failures_are_recorded_and_the_others_go_on(command_line, folder: Path) -> None:
    (folder / "junk.step").write_text("junk")
    (folder / "wrong.csv").write_text(LAYUP.replace("0.3", "thick"), encoding="utf-8")
    table(
        folder,
        "absent.step,1,1,,,absent.step",
        "rod.brep,1,-12,,,refused.brep",
        "rod.brep,4,1,,,four.brep",
        "junk.step,1,1,,,junk.step",
        "rod.brep,1,,wrong.csv,,wrong.brep",
        "rod.brep,1,,absent.csv,,none.brep",
        "rod.brep,all,-12,,,partly.brep",
        "rod.brep,1,1,,,good.brep",
    )
    reasons = [
        "absent.step: there is no such file",
        "face 1 refused at analysis: curvature-limit: ",
        "rod.brep: there is no face 4; it has 3",
        "could not be read as STEP",
        "row 3, column thickness_mm: found 'thick'",
        "absent.csv",
        "face 1 refused at analysis: curvature-limit: ",
        "",
    ]
    for again in range(2):
        run = command_line("batch", "jobs.csv", "-o", "out", "--workers", 2)
        assert run.returncode == 1 and "Traceback" not in run.stderr
        before = " before" if again else ""
        assert states(folder) == ["failed"] * 6 + [f"partly done{before}", f"done{before}"]
        for row, reason in zip(summary(folder), reasons):
            assert reason in row["reason"]
            assert reason in record(folder, row["output"])["reason"]
            assert (f"row {row['row']}: {row['output']}: " in run.stderr) == bool(reason)
        assert "1 of 8 jobs done" in run.stderr and "6 failed, 1 partly done" in run.stderr
    refusal = record(folder, "refused.brep")["report"]
    assert refusal["status"] == "curvature-limit" and refusal["limits"]["negative"] == pytest.approx(-10.0, abs=1e-6)
    outputs = sorted(path.name for path in (folder / "out").iterdir() if path.suffix == ".brep")
    assert outputs == ["good.brep", "partly.brep"]
    assert len(files.read_faces(str(folder / "out" / "partly.brep"))) == 2


def test_an_output_that_the_row_no_longer_asks_for_goes(command_line, folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "out" / "own.brep").write_text("the user's own")
    table(folder, "rod.brep,1,1,,,a.brep", "rod.brep,1,-12,,,own.brep")
    command_line("batch", "jobs.csv", "-o", "out")
    assert (folder / "out" / "a.brep").is_file() and (folder / "out" / "own.brep").read_text() == "the user's own"
    table(folder, "rod.brep,1,-11,,,a.brep")
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 1
    assert not (folder / "out" / "a.brep").exists() and states(folder) == ["failed"]


@pytest.mark.parametrize(
    "header,rows,places",
    [
        (HEADER, ["rod.brep,1,far,,,a.brep"], ["row 2, column distance: found 'far', expected a number of mm"]),
        (HEADER, ["rod.brep,0,1,,,a.brep"], ["row 2, column face: found '0', expected a face number from 1, or all"]),
        (HEADER, ["rod.brep,1,1,,0,a.brep"], ["row 2, column tolerance: found '0'"]),
        (HEADER, ["rod.brep,1,nan,,,a.brep", ",1,1,,,b.brep"], ["row 2, column distance", "row 3, column input"]),
        (
            HEADER,
            ["rod.brep,1,,,,a.brep"],
            ["row 2, column distance: found nothing, expected a number of mm, or a layup"],
        ),
        (HEADER, ["rod.brep,1,1,layup.csv,,a.brep"], ["row 2, column layup: found 'layup.csv', expected either"]),
        (HEADER, ["rod.brep,all,,layup.csv,,a.brep"], ["row 2, column face: found 'all'"]),
        (HEADER, ["rod.brep,1,1,,,a.dwg"], ["row 2, column output: found 'a.dwg'"]),
        (HEADER, ["rod.brep,1,1,,,"], ["row 2, column output: found nothing"]),
        (HEADER, ["rod.brep,1,1,,,../rod2.brep"], ["row 2, column output: found '../rod2.brep'"]),
        (HEADER, ["rod.brep,1,1,,,/a.brep"], ["row 2, column output: found '/a.brep'"]),
        (HEADER, ["rod.brep,1,1,,,a.brep", "", "rod.brep,2,1,,,A.brep"], ["row 4, column output: found 'A.brep'"]),
        (HEADER, ["rod.brep,1,1,,,a.brep,x"], ["row 2: found 'x' in cell 7, expected 6 cells"]),
        (HEADER, ["rod.brep,1,1,,,../rod.brep"], ["row 2, column output"]),
        (HEADER, [], ["found no rows"]),
        ("", [], ["row 1: found nothing, expected a header row with input, face"]),
        ("input,face,colour,output\n", ["rod.brep,1,red,a.brep"], ["row 1, column colour: found a column", "distance"]),
        ("face,distance,output\n", ["1,1,a.brep"], ["row 1, column input: found no such column"]),
        ("input,face,face,distance,output\n", ["rod.brep,1,1,1,a"], ["row 1, column face: found the column a second"]),
        (HEADER, ['"rod.brep,1,1,,,a.brep'], ["closed quotation marks"]),
    ],
)
def test_a_wrong_table_names_row_and_column(command_line, folder: Path, header, rows, places) -> None:
    table(folder, *rows, header=header)
    run = command_line("batch", "jobs.csv", "-o", "out")
    assert run.returncode == 2 and run.stdout == "" and "Traceback" not in run.stderr
    assert "jobs.csv: " in run.stderr and all(place in run.stderr for place in places), run.stderr
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    "arguments,reason",
    [
        (["absent.csv", "-o", "out"], "absent.csv: found No such file"),
        (["jobs.csv"], "required: -o"),
        (["jobs.csv", "-o", "out", "--workers", "0"], "at least one worker"),
        (["jobs.csv", "-o", "out", "--workers", "many"], "not a whole number"),
        (["jobs.csv", "-o", "rod.brep"], "rod.brep: cannot be used for results"),
        (["jobs.csv", "-o", "."], "row 2, column output: found 'rod.brep', expected a file that no job reads"),
    ],
)
def test_bad_usage_starts_nothing(command_line, folder: Path, arguments: List[str], reason: str) -> None:
    table(folder, "rod.brep,1,1,,,rod.brep")
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    run = command_line("batch", *arguments)
    assert run.returncode == 2 and reason in run.stderr and "Traceback" not in run.stderr, run.stderr
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_other_forms_of_the_table(tmp_path: Path) -> None:
    rows = ["2,5;x.step;ALL;o.step;;0,01", ";y.step;3;p.step;l.yaml;"]
    path = table(tmp_path, *rows, header="distance_mm;Input;face;output;layup;Tolerance_mm\n")
    first, second = read_jobs(str(path))
    assert (first.row, first.face, first.distance, first.tolerance, first.layup) == (2, None, 2.5, 0.01, "")
    assert (second.row, second.face, second.distance, second.tolerance, second.layup) == (3, 3, None, None, "l.yaml")
    path.write_bytes(b"input,face\n\xff")
    with pytest.raises(JobsError, match="UTF-8"):
        read_jobs(str(path))


def test_paths_start_at_the_table_or_else_here(command_line, folder: Path) -> None:
    (folder / "tables").mkdir()
    os.rename(folder / "rod.brep", folder / "tables" / "rod.brep")
    table(folder / "tables", "rod.brep,1,1,,,a.brep", "wing.step,1,1,,,b.brep", f"{folder}/wing.step,1,2,,,c.brep")
    run = command_line("batch", "tables/jobs.csv", "-o", "out")
    assert run.returncode == 0, run.stderr
    assert states(folder) == ["done"] * 3


def test_ctrl_c_keeps_what_is_done_and_resumes(launcher: Path, command_line, folder: Path) -> None:
    long_jobs(folder)
    process = start(launcher, folder, "--workers", "2")
    workers = children(process.pid)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=120)
    assert process.returncode == 130
    assert errors.startswith("laminate-offset: cancelled; 1 of 4 jobs done. Run it again to go on."), errors
    assert len(workers) == 2 and not any(os.path.exists(f"/proc/{worker}") for worker in workers)
    assert sorted(os.listdir(folder / "out")) == ["quick.step", "quick.step.json", "summary.csv"]
    assert states(folder) == ["done", "not run", "not run", "not run"]
    table(folder, "wing.step,1,5,,,quick.step", "rod.brep,1,1,,,long1.brep")
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done before", "done"]


def test_a_killed_run_resumes(launcher: Path, command_line, folder: Path) -> None:
    long_jobs(folder)
    process = start(launcher, folder, "--workers", "1")
    (worker,) = children(process.pid)
    process.kill()
    process.communicate(timeout=60)
    wait_for_end(worker)
    assert not (folder / "out" / "long1.brep").exists() and not (folder / "out" / "long1.brep.json").exists()
    # What a process that no longer lives was writing goes, what a living one writes stays.
    for number in (worker, os.getpid()):
        (folder / "out" / f".laminate-offset-{number}-half").mkdir()
    table(folder, "wing.step,1,5,,,quick.step", "rod.brep,1,1,,,long1.brep")
    assert command_line("batch", "jobs.csv", "-o", "out").returncode == 0
    assert states(folder) == ["done before", "done"]
    assert leftovers(folder) == [str(folder / "out" / f".laminate-offset-{os.getpid()}-half")]


def test_a_worker_that_dies_fails_its_job_only(launcher: Path, folder: Path) -> None:
    long_jobs(folder, 1)
    with open(folder / "jobs.csv", "a", encoding="utf-8") as stream:
        stream.write("rod.brep,1,1,,,after.brep\n")
    process = start(launcher, folder, "--workers", "1")
    (worker,) = children(process.pid)
    os.kill(worker, signal.SIGKILL)
    output, errors = process.communicate(timeout=120)
    assert process.returncode == 1 and output == "row 4: after.brep: done\n"
    reason = "the process that worked on it ended early (Killed)"
    assert f"row 3: long1.brep: failed: {reason}" in errors
    assert record(folder, "long1.brep")["reason"] == reason and record(folder, "long1.brep")["state"] == "failed"
    assert states(folder) == ["done", "failed", "done"] and leftovers(folder) == []


def test_two_batches_do_not_share_a_folder(launcher: Path, command_line, folder: Path) -> None:
    long_jobs(folder, 1)
    process = start(launcher, folder)
    try:
        run = command_line("batch", "jobs.csv", "-o", "out")
        assert run.returncode == 2 and "another batch is working in this folder" in run.stderr
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)


PAD_HEADER = "input,face,layup,boundaries,side,drop_off,ramp_slope,stagger,boundary_gap,output\n"
PADS = "ply,material,thickness_mm,angle_deg,boundary\nP1,tape,0.2,0,\nP2,tape,0.2,90,pad\nP3,tape,0.2,90,pad\nP4,tape,0.2,0,\n"


@pytest.fixture
def pads(folder: Path) -> Path:
    """The folder with a layup of a pad, and its boundary, 1 mm above the wing."""
    (folder / "pads.csv").write_text(PADS, encoding="utf-8")
    wing = files.read_faces(str(folder / "wing.step"))[0]
    document = FreeCAD.newDocument("Pads")
    middle = FreeCAD.Vector(18.0, 50.0, 0.0)
    foot = wing.Surface.value(*wing.Surface.parameter(middle))
    document.addObject("Part::Feature", "pad").Shape = Part.makeCircle(12.0, foot + FreeCAD.Vector(0.0, 0.0, 1.0))
    document.saveAs(str(folder / "pads.FCStd"))
    FreeCAD.closeDocument(document.Name)
    return folder


def test_stacks_with_boundaries(command_line, pads: Path) -> None:
    rows = [
        "wing.step,1,pads.csv,pads.FCStd,,20mm,,,,inside.brep",
        "wing.step,1,pads.csv,pads.FCStd,pad=outside,20mm,steepest,,,outside.brep",
        'wing.step,1,pads.csv,pads.FCStd,,20mm,,"pad=0,3",,staggered.brep',
        "wing.step,1,pads.csv,pads.FCStd,,20mm,,,0.01,far.brep",
        "wing.step,1,pads.csv,,,,,,,missing.brep",
        "wing.step,1,pads.csv,pads.FCStd,tip=left,,,,,side.brep",
    ]
    path = table(pads, *rows, header=PAD_HEADER)
    run = command_line("batch", path, "-o", pads / "out")
    assert run.returncode == 1, run.stderr
    assert states(pads) == ["done"] * 3 + ["failed"] * 3, summary(pads)
    reasons = [row["reason"] for row in summary(pads)]
    assert "stands" in reasons[3] and "boundary" in reasons[4] and "'tip'" in reasons[5]
    areas = {
        name: [face.Area for face in files.read_faces(str(pads / "out" / f"{name}.brep"))]
        for name in ("inside", "outside", "staggered")
    }
    whole = areas["inside"][0]
    assert areas["inside"][1] + areas["outside"][1] == pytest.approx(whole, rel=1e-2)
    assert areas["staggered"][1] == pytest.approx(areas["inside"][1], rel=1e-6)
    assert areas["staggered"][2] == pytest.approx(areas["inside"][2] * (9.0 / 12.0) ** 2, rel=0.05)
    assert record(pads, "outside.brep")["job"]["side"] == ["pad=outside"]
    assert record(pads, "outside.brep")["report"]["stack"][1]["ramp"]["steepest_slope"] <= 0.2 / 20.0
    run = command_line("batch", path, "-o", pads / "out")
    assert states(pads) == ["done before"] * 3 + ["failed"] * 3
    (pads / "pads.FCStd").write_bytes((pads / "pads.FCStd").read_bytes() + b" ")  # another digest
    table(pads, rows[0], header=PAD_HEADER)
    command_line("batch", path, "-o", pads / "out")
    assert states(pads) == ["done"]


def test_columns_on_boundaries_are_checked(folder: Path) -> None:
    rows = [
        "wing.step,1,layup.csv,pads.FCStd,pad=above,,,,,a.brep",
        "wing.step,1,layup.csv,pads.FCStd,,20kg,,,,b.brep",
        "wing.step,1,layup.csv,pads.FCStd,,0,,,,c.brep",
        "wing.step,1,layup.csv,pads.FCStd,,,flat,,,d.brep",
        "wing.step,1,layup.csv,pads.FCStd,,,,pad=x,,e.brep",
        "wing.step,1,layup.csv,pads.FCStd,,,,,-1,f.brep",
        "wing.step,1,layup.csv,,pad=left,,,,,g.brep",
    ]
    with pytest.raises(JobsError) as wrong:
        read_jobs(str(table(folder, *rows, header=PAD_HEADER)))
    columns = ["side", "drop_off", "drop_off", "ramp_slope", "stagger", "boundary_gap", "side"]
    assert [(problem.row, problem.column) for problem in wrong.value.problems] == list(enumerate(columns, start=2))
    header = "input,face,distance,boundaries,output\n"
    with pytest.raises(JobsError, match="boundaries: found 'pads.FCStd', expected nothing where no layup"):
        read_jobs(str(table(folder, "wing.step,1,5,pads.FCStd,a.brep", header=header)))
    (job,) = read_jobs(str(table(folder, "wing.step,1,5,,,a.brep")))
    assert set(job.task()) == {"input", "face", "distance", "layup", "tolerance", "output"}


def test_the_example_of_a_pad(command_line, tmp_path: Path) -> None:
    run = command_line("batch", PROJECT / "resources" / "examples" / "jobs_pad.csv", "-o", tmp_path / "out")
    assert run.returncode == 0, run.stderr
    stack = record(tmp_path, "panel_pad.step")["report"]
    assert [ply["boundary"] for ply in stack["stack"]] == ["", "", "PadContour", "PadContour", "", ""]
    assert stack["certified_error"] <= 1e-3 and stack["boundary_gaps"]["PadContour"] < 1e-6
    faces = files.read_faces(str(tmp_path / "out" / "panel_pad.step"))
    assert len(faces) == 6 and all(face.isValid() for face in faces)
    assert faces[2].Area < 0.1 * faces[0].Area
