# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same tests inside freecadcmd, which finds the add-on by itself, and the two examples."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ADDON = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset"
EXAMPLES = ADDON / "resources" / "examples"
PANEL = EXAMPLES / "panel_two_holes.step"


def run_freecadcmd(*arguments, home, install="user"):
    """Runs freecadcmd with the add-on from -M or from the user's Mod folder, never from PYTHONPATH."""
    environment = dict(os.environ, FREECAD_USER_HOME=str(home), HOME=str(home))
    environment.pop("PYTHONPATH", None)
    command = ["freecadcmd", *map(str, arguments)]
    if install == "option":
        command += ["-M", str(ADDON)]  # last: FreeCAD 0.20 does not know it before -c
    else:
        (home / "Mod").mkdir()
        (home / "Mod" / ADDON.name).symlink_to(ADDON)
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=240, check=False)


@pytest.mark.parametrize("install", ["option", "user"])
def test_feature_tests_pass_inside_freecadcmd(tmp_path, install):
    files = [str(HERE / f"test_{name}.py") for name in ("feature", "placement")]
    # FreeCAD 1.0 drops what is not flushed yet.
    run = f"code = pytest.main(['-q', '-p', 'no:cacheprovider'] + {files!r})"
    code = f"import sys, pytest; {run}; sys.stdout.flush(); sys.exit(int(code))"
    done = run_freecadcmd("-c", code, home=tmp_path, install=install)
    assert done.returncode == 0, done.stdout + done.stderr
    assert " passed" in done.stdout and " skipped" not in done.stdout


_SAVE = """
import FreeCAD as App
from laminate_offset.features.offset_face import make_offset_face
doc = App.newDocument("T")
ball = doc.addObject("Part::Sphere", "Ball")
doc.recompute()
make_offset_face(ball, "Face1", 2)
doc.saveAs({path!r})
"""

_REOPEN = """
import FreeCAD as App
doc = App.openDocument({path!r})
doc.getObject("Ball").Radius = 20
doc.recompute()
assert doc.getObject("OffsetFace").Shape.Faces[0].Surface.Radius == 22
print("REOPENED")
"""


@pytest.mark.parametrize("install", ["option", "user"])
def test_document_lives_on_when_nothing_was_imported(tmp_path, install):
    """In FreeCAD the add-on is among the Mod folders, so that a document finds its code by itself."""
    path = str(tmp_path / "saved.FCStd")
    for number, code in enumerate((_SAVE, _REOPEN)):
        home = tmp_path / f"home{number}"
        home.mkdir()
        done = run_freecadcmd("-c", code.format(path=path), home=home, install=install)
        assert done.returncode == 0, done.stdout + done.stderr
    assert "REOPENED" in done.stdout


def test_headless_example_in_plain_python(tmp_path):
    out = tmp_path / "offset.FCStd"
    done = subprocess.run(
        [sys.executable, EXAMPLES / "offset_headless.py", PANEL, "--face", "1", "--distance", "5", "--out", out],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert out.is_file() and "B-spline" in done.stdout


def test_headless_example_refuses_with_an_exit_code(tmp_path):
    out = tmp_path / "offset.FCStd"
    command = [sys.executable, EXAMPLES / "offset_headless.py", PANEL, "--out", out]
    refused = subprocess.run([*command, "--distance", "-1000000"], capture_output=True, text=True, check=False)
    assert refused.returncode == 1 and "Feasible distances" in refused.stderr and not out.exists()
    unknown = subprocess.run([*command, "--face", "99"], capture_output=True, text=True, check=False)
    assert unknown.returncode == 1 and "Face99" in unknown.stderr and not out.exists()
    missing = [sys.executable, EXAMPLES / "offset_headless.py", tmp_path / "none.step", "--out", out]
    assert subprocess.run(missing, capture_output=True, check=False).returncode == 2


def test_headless_example_in_freecadcmd(tmp_path):
    out = tmp_path / "offset.FCStd"
    arguments = ["offset_headless.py", str(PANEL), "--distance", "-5", "--out", str(out)]
    script = str(EXAMPLES / "offset_headless.py")
    code = f"import runpy, sys; sys.argv = {arguments!r}; runpy.run_path({script!r}, run_name='__main__')"
    done = run_freecadcmd("-c", code, home=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert out.is_file()


def test_macro_example(tmp_path):
    """The macro offsets its own demonstration face when nothing is selected."""
    macro = tmp_path / "offset_face.FCMacro"
    shutil.copy(EXAMPLES / "offset_face.FCMacro", macro)
    done = run_freecadcmd(macro, home=tmp_path)
    assert "Offset of Panel: Face1" in done.stdout, done.stdout + done.stderr
    assert "Exception" not in done.stdout + done.stderr


@pytest.mark.parametrize("install", ["option", "user"])
def test_own_tests_run_in_freecad(tmp_path, install):
    """What a user sees in FreeCAD's test workbench: the module is registered and passes."""
    code = (
        "import sys, unittest, FreeCAD; assert 'TestLaminateOffset' in FreeCAD.__unit_test__; "
        "suite = unittest.defaultTestLoader.loadTestsFromName('TestLaminateOffset'); "
        "done = unittest.TextTestRunner(stream=sys.stdout).run(suite); "
        "sys.exit(0 if done.wasSuccessful() and done.testsRun == 10 else 1)"
    )
    done = run_freecadcmd("-c", code, home=tmp_path, install=install)
    assert done.returncode == 0, done.stdout + done.stderr
