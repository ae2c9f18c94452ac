# SPDX-License-Identifier: LGPL-2.1-or-later
"""What README promises runs as it stands there."""

import csv
import json
import re
import shlex
import sys
from pathlib import Path
from typing import List

import pytest
from example_tools import BUILD, ROOT, run

README = (ROOT / "README.md").read_text(encoding="utf-8")
TOOL = "build/release/bin/laminate-offset"


def blocks(language: str) -> List[str]:
    """The fenced code blocks of a language."""
    return re.findall(r"^```%s\n(.*?)^```" % language, README, re.MULTILINE | re.DOTALL)


def commands() -> List[str]:
    """All shell commands, without their comments."""
    lines = [line.split("  #")[0].split(" #")[0].strip() for block in blocks("sh") for line in block.splitlines()]
    return [line for line in lines if line]


def tool_commands() -> List[str]:
    return [line for line in commands() if line.startswith(TOOL)]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder in which the project's files are found as from its root, but where nothing is left in the project."""
    for name in ("resources", "scripts"):
        (tmp_path / name).symlink_to(ROOT / name)
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "release").symlink_to(BUILD)
    return tmp_path


def test_python_example_is_short_and_runs(folder):
    (example,) = blocks("python")
    assert len([line for line in example.splitlines() if line.strip()]) <= 10
    (folder / "example.py").write_text(example, encoding="utf-8")
    done = run([sys.executable, "example.py"], folder)
    assert done.returncode == 0, done.stdout
    assert "3 loops, 9 edges" in done.stdout
    assert '"status": "ok"' in done.stdout
    assert (folder / "ply.step").stat().st_size > 1000


def test_readme_shows_the_command_line():
    assert len(tool_commands()) >= 2


@pytest.mark.parametrize("command", tool_commands())
def test_command_line_example_runs(command, folder):
    words = shlex.split(command)
    done = run(words, folder)
    assert done.returncode == 0, done.stdout
    written = {option: folder / words[words.index(option) + 1] for option in ("-o", "--report") if option in words}
    assert written, "an example shows its result in a file"
    if words[1] == "batch":
        with open(written["-o"] / "summary.csv", encoding="utf-8", newline="") as stream:
            assert [row["state"] for row in csv.DictReader(stream)] == ["done"] * 3
    elif "-o" in written:
        assert written["-o"].stat().st_size > 1000
    if "--report" in written:
        report = json.loads(written["--report"].read_text(encoding="utf-8"))
        for face in report if "all" in words else [report]:
            assert face["status"] == "ok"
            if words[1] == "offset":
                assert (face["loops"], face["edges"]) == (3, 9)
            elif words[1] == "plies":
                assert face["plies"] == len(face["stack"]) == 6 and face["certified_error"] <= face["tolerance"]
            else:
                assert face["proven"] and face["negative"]["distance"] < 0


def test_add_on_can_be_linked_into_the_mod_folder(folder):
    home = folder / "home"
    home.mkdir()
    lines = [line for line in commands() if "share/FreeCAD/Mod" in line]
    assert len(lines) == 2
    done = run(["sh", "-ec", "\n".join(lines)], folder, {"HOME": str(home), "PWD": str(folder)})
    assert done.returncode == 0, done.stdout
    assert (home / ".local/share/FreeCAD/Mod/LaminateOffset/Init.py").exists()


def test_scripts_and_links_exist():
    assert all((ROOT / line).exists() for line in commands() if line.startswith("scripts/"))
    links = re.findall(r"\]\(([^)#:]+)\)", README)
    assert len(links) >= 3
    missing = [link for link in links if not (ROOT / link).exists()]
    assert not missing


def test_every_command_of_the_readme_is_tested_here():
    tested = [line for line in commands() if line.startswith((TOOL, "scripts/")) or "share/FreeCAD/Mod" in line]
    assert tested == commands()
