# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package imports wherever FreeCAD's Python runs, finds FreeCAD by itself, and says what to do when it cannot."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import laminate_offset as lo
import pytest

PACKAGE = Path(lo.__file__).parent
OFFSET_A_SPHERE = (
    "r = lo.offset_face(Part.makeSphere(10).Faces[0], 1.0); assert abs(r.face.Surface.Radius - 11) < 1e-12"
)


def without_freecad() -> str:
    """A PYTHONPATH with the add-on alone."""
    return str(PACKAGE.parent)


def test_freecad_is_found_without_pythonpath(python) -> None:
    run = python(f"import laminate_offset as lo, Part; {OFFSET_A_SPHERE}; print('done')", PYTHONPATH=without_freecad())
    assert run.stdout == "done\n", run.stderr


def test_a_missing_freecad_says_what_to_do(python, tmp_path: Path) -> None:
    run = python("import laminate_offset", PYTHONPATH=without_freecad(), FREECAD_LIB=str(tmp_path))
    assert run.returncode == 1
    message = run.stderr.strip().splitlines()[-1]
    assert message.startswith("ImportError: laminate_offset needs FreeCAD's Python modules")
    assert "PYTHONPATH" in message and "FREECAD_LIB" in message and str(tmp_path) in message


def test_a_broken_freecad_says_what_is_wrong(python, tmp_path: Path) -> None:
    (tmp_path / "FreeCAD.py").write_text("raise ImportError('libGL is missing')\n")
    run = python("import laminate_offset", PYTHONPATH=without_freecad(), FREECAD_LIB=str(tmp_path))
    assert run.returncode == 1
    assert "FreeCAD could not be loaded (libGL is missing)" in run.stderr


def test_another_python_is_told_which_to_use(python, tmp_path: Path) -> None:
    copy = tmp_path / "laminate_offset"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("_core.*.so", "__pycache__"))
    run = python("import laminate_offset", PYTHONPATH=str(tmp_path))
    assert run.returncode == 1
    message = run.stderr.strip().splitlines()[-1]
    assert f"could not be loaded by Python {sys.version_info[0]}.{sys.version_info[1]}" in message
    assert "/usr/bin/python3" in message


@pytest.mark.parametrize(
    "order", ["import pivy.coin; import laminate_offset as lo", "import laminate_offset as lo; import pivy.coin"]
)
def test_it_shares_swigs_runtime_with_coin(python, order: str) -> None:
    pytest.importorskip("pivy", reason="pivy is not installed")
    run = python(f"{order}; import Part; {OFFSET_A_SPHERE}; print(lo.shape_exchange(), pivy.coin.SbVec3f(1, 2, 3)[1])")
    assert run.stdout == "zero-copy 2.0\n", run.stderr


def test_coin_still_works_after_offsets(python) -> None:
    pytest.importorskip("pivy", reason="pivy is not installed")
    run = python(
        f"import laminate_offset as lo, Part; {OFFSET_A_SPHERE}\n"
        f"import pivy.coin; root = pivy.coin.SoSeparator(); root.addChild(pivy.coin.SoCube()); {OFFSET_A_SPHERE}\n"
        "print(root.getNumChildren(), type(root.getChild(0)).__name__)"
    )
    assert run.stdout == "1 SoCube\n", run.stderr


def test_it_works_in_freecadcmd(tmp_path: Path) -> None:
    program = shutil.which("freecadcmd")
    if program is None:
        pytest.skip("freecadcmd is not installed")
    code = (
        f"import sys; sys.path.insert(0, {str(PACKAGE.parent)!r})\n"
        f"import laminate_offset as lo, Part; {OFFSET_A_SPHERE}\n"
        "print('way', lo.shape_exchange(), flush=True); sys.exit(7)"  # FreeCAD 1.0 ends without a flush of its own
    )
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    run = subprocess.run([program, "-c", code], env=environment, capture_output=True, text=True, timeout=120)
    assert run.returncode == 7, run.stderr
    assert "way zero-copy" in run.stdout
