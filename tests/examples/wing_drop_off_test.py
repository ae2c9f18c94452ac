# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nine plies on the wing skin, two patches and a staggered drop-off of five among them: no ply crosses another."""

import json
import sys
from pathlib import Path

from example_tools import BUILD, EXAMPLES, run


def test_the_staggered_drop_off_is_measured(tmp_path: Path) -> None:
    command = [sys.executable, str(EXAMPLES / "wing_drop_off.py"), "--out", str(tmp_path), "--samples", "80"]
    done = run(
        command + ["--no-picture"], tmp_path, {"PYTHONPATH": str(BUILD / "Mod" / "LaminateOffset")}, timeout=1000
    )
    assert done.returncode == 0, done.stdout
    found = json.loads((tmp_path / "wing_drop_off.json").read_text(encoding="utf-8"))
    assert found["plies"] == 9 and found["ply_places"] > 2000 and found["line_places"] > 100
    assert found["certified_error"] <= 1e-3 and found["edge_error"] <= 1e-3
    assert found["highest_pocket"] > 0.2  # there are drop-offs to be seen
    assert (tmp_path / "wing_drop_off.step").stat().st_size > 10000
