# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of the examples share: places, and runs of the examples' scripts."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Dict, List, Optional

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources" / "examples"
BUILD = Path(os.environ.get("LAMINATE_OFFSET_BUILD_DIR", ROOT / "build" / "release"))


def run(
    command: List[str], folder: Path, variables: Optional[Dict[str, str]] = None, timeout: int = 280
) -> "subprocess.CompletedProcess":
    """Runs a command in a folder; returns the completed process with its output as text."""
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", **(variables or {}))
    return subprocess.run(
        command,
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=timeout,
    )


def run_script(script: Path, arguments: List[str], folder: Path) -> str:
    """Runs one of the project's Python scripts, which must succeed; returns its output."""
    done = run([sys.executable, str(script), *arguments], folder)
    assert done.returncode == 0, done.stdout
    return done.stdout
