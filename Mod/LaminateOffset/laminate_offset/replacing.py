# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a file in one step, so that there is never half a file. Needs nothing of FreeCAD."""

import glob
import os
import shutil
import tempfile
from contextlib import contextmanager
from typing import Iterator


# Begins the names of the folders that files are written in, followed by the number of the process.
PREFIX = ".laminate-offset-"


class FileError(Exception):
    """A file that cannot be read or written; the text names the file and the reason."""


@contextmanager
def replacing(path: str) -> Iterator[str]:
    """A path to write to, which becomes `path` when the block ends without an exception.

    It is a file of the same name in a folder of its own beside the target: some writers put the name into the file,
    and within one file system the move is a single step.
    """
    target = os.path.realpath(path)
    try:
        folder = tempfile.mkdtemp(prefix=f"{PREFIX}{os.getpid()}-", dir=os.path.dirname(target))
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror}.") from error
    try:
        temporary = os.path.join(folder, os.path.basename(target))
        yield temporary
        if not os.path.isfile(temporary):
            raise FileError(f"{path}: nothing was written; is the disk full?")
        os.replace(temporary, target)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error}") from error
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def remove_leftovers(folder: str) -> None:
    """Removes what processes that were killed while they wrote a file into this folder have left behind."""
    for leftover in glob.glob(os.path.join(glob.escape(folder), f"{PREFIX}*-*")):
        process = os.path.basename(leftover)[len(PREFIX) :].split("-")[0]
        if process.isdigit() and not _lives(int(process)):
            shutil.rmtree(leftover, ignore_errors=True)


def _lives(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True
    try:  # one that has ended but that its parent has not asked about yet is a zombie
        with open(f"/proc/{process}/stat", encoding="utf-8", errors="replace") as stream:
            return stream.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return True
