# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests of the Python module and of the command line."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable

import pytest

PROJECT = Path(os.environ.get("LAMINATE_OFFSET_PROJECT_DIR", Path(__file__).resolve().parents[2]))


@pytest.fixture(scope="session")
def data_dir() -> Path:
    """The folder of real files beside the project; its tests are skipped where it is absent."""
    folder = Path(os.environ.get("LAMINATE_OFFSET_SHARED_DATA", PROJECT.parent / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip("the shared data folder is not beside the project")
    return folder


@pytest.fixture(scope="session")
def launcher() -> Path:
    """The command line of the build tree."""
    return Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "bin" / "laminate-offset"


@pytest.fixture
def command_line(launcher: Path, tmp_path: Path) -> Callable[..., "subprocess.CompletedProcess[str]"]:
    """Runs laminate-offset in a folder of its own, as a user without any PYTHONPATH would."""

    def run(*arguments: Any) -> "subprocess.CompletedProcess[str]":
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        command = [str(launcher), *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300)

    return run


@pytest.fixture
def python() -> Callable[..., "subprocess.CompletedProcess[str]"]:
    """Runs a piece of Python in a process of its own; keyword arguments change the environment, None unsets."""

    def run(code: str, **changes: Any) -> "subprocess.CompletedProcess[str]":
        environment = {**os.environ, **changes}
        environment = {name: value for name, value in environment.items() if value is not None}
        command = [sys.executable, "-c", code]
        return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)

    return run
