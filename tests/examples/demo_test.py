# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of scripts/demo after the build, one by one."""

import importlib.util
import json
import re
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from example_tools import BUILD, EXAMPLES, ROOT, run, run_script

PANEL = EXAMPLES / "panel_two_holes.step"


def load(script: Path):
    """A script of the examples as a module."""
    spec = importlib.util.spec_from_file_location(script.stem, script)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def renderer():
    return load(EXAMPLES / "render_offset.py")


@pytest.fixture(scope="module")
def offset_at_150(tmp_path_factory) -> Path:
    """Folder with offset.step and report.json of the panel at 150 mm."""
    folder = tmp_path_factory.mktemp("offset")
    tool = BUILD / "bin" / "laminate-offset"
    request = ["offset", str(PANEL), "--face", "1", "--distance", "150", "-o", "offset.step", "--report", "report.json"]
    done = run([str(tool), *request], folder)
    assert done.returncode == 0, done.stdout
    return folder


def test_document_holds_base_and_parametric_offset(tmp_path):
    out = tmp_path / "panel.FCStd"
    run_script(EXAMPLES / "demo_document.py", [str(PANEL), "1", "5", "0.001", str(out)], tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["panel.FCStd"]
    with zipfile.ZipFile(out) as document:
        text = document.read("Document.xml").decode()
        views = document.read("GuiDocument.xml").decode()
        shapes = [name for name in document.namelist() if name.endswith((".brp", ".bin"))]
    assert 'name="Base"' in text and 'name="Offset"' in text
    assert len(shapes) == 2 and len(set(shapes)) == 2
    visible = re.findall(r'<ViewProvider name="(\w+)".*?"Visibility".*?<Bool value="true"/>', views)
    assert visible == ["Base", "Offset"], "FreeCAD hides what has no view settings"
    assert 'module="laminate_offset.gui.view_providers.offset_face" class="OffsetFaceViewProvider"' in views


def test_document_of_a_refused_offset_is_not_written(tmp_path):
    out = tmp_path / "panel.FCStd"
    arguments = [str(PANEL), "1", "-5000", "0.001", str(out)]
    done = run([sys.executable, str(EXAMPLES / "demo_document.py"), *arguments], tmp_path)
    assert done.returncode == 1
    assert "demo_document:" in done.stdout
    assert not list(tmp_path.iterdir())


def test_picture_shows_base_and_offset(offset_at_150, tmp_path, renderer):
    arguments = [str(PANEL), str(offset_at_150 / "offset.step"), "picture.png", "--renderer", "matplotlib"]
    arguments += ["--report", str(offset_at_150 / "report.json"), "--subject", "A panel"]
    run_script(EXAMPLES / "render_offset.py", arguments, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["picture.png"]
    image = renderer.plt.imread(str(tmp_path / "picture.png"))[:, :, :3]
    assert image.shape[0] > 300 and image.shape[1] > 500
    red, blue = image[:, :, 0], image[:, :, 2]
    assert np.mean(red - blue > 0.2) > 0.15, "the offset's colour covers a good part"
    assert np.mean(blue - red > 0.03) > 0.01, "the base shows"


def test_caption_never_calls_a_sampled_figure_proven(tmp_path, renderer):
    report = {
        "surface": {"poles_u": 9, "poles_v": 8, "type": "bspline"},
        "certified_error": None,
        "sampled_error": 4e-4,
        "tolerance": 1e-3,
        "distance": 150.0,
    }
    path = tmp_path / "report.json"
    path.write_text(json.dumps(report), encoding="utf-8")
    text = renderer.caption_text("A panel", str(path))
    assert "sampled deviation 0.0004 mm" in text and "150 mm" in text and "9 x 8 poles" in text
    assert "proven" not in text
    path.write_text(json.dumps(dict(report, certified_error=9e-4)), encoding="utf-8")
    assert "proven deviation 0.0009 mm" in renderer.caption_text("A panel", str(path))


def test_renderer_refuses_missing_models(tmp_path):
    script = EXAMPLES / "render_offset.py"
    done = run([sys.executable, str(script), "absent.step", "absent.step", "out.png"], tmp_path)
    assert done.returncode == 2
    assert "absent.step" in done.stdout


def test_demo_asks_nothing_and_stops_at_the_first_failure():
    text = (ROOT / "scripts" / "demo").read_text(encoding="utf-8")
    assert "set -euo pipefail" in text
    assert "read " not in text
