# SPDX-License-Identifier: LGPL-2.1-or-later
"""The record of a job: a JSON file beside its output, with what was done and from what."""

import hashlib
import json
import os
from typing import Any, Dict, Mapping, Optional

from .. import __version__
from ..files import write_json
from .jobs import RECORD_ENDING, Job

FORMAT, VERSION = "laminate-offset job", 1

DONE, PARTLY, FAILED, NOT_RUN = "done", "partly done", "failed", "not run"


def record_path(output: str) -> str:
    """The record of an output file."""
    return output + RECORD_ENDING


def digest(path: str) -> Optional[str]:
    """SHA-256 of a file's content, as hexadecimal text; None where it cannot be read."""
    found = hashlib.sha256()
    try:
        with open(path, "rb") as stream:
            for block in iter(lambda: stream.read(1 << 20), b""):
                found.update(block)
    except OSError:
        return None
    return found.hexdigest()


def make_record(
    task: Mapping[str, Any], digests: Mapping[str, Optional[str]], state: str, reason: str, **more: Any
) -> Dict[str, Any]:
    """The content of a record.

    Args:
        task: what was to be done, see Job.task.
        digests: those of the files that it was done from, see `digest`.
        state: DONE, PARTLY (some of all faces were refused) or FAILED.
        reason: what was refused or failed; "" where nothing was.
        more: the report and further figures.
    """
    head = {"format": FORMAT, "version": VERSION, "program": f"laminate-offset {__version__}"}
    return {**head, "job": dict(task), "sha256": dict(digests), "state": state, "reason": reason, **more}


def write_record(record: Mapping[str, Any], output: str) -> None:
    """Writes the record of an output file in one step."""
    write_json(record, record_path(output))


def read_record(output: str) -> Optional[Dict[str, Any]]:
    """The record of an output file; None where there is none that could be used."""
    try:
        with open(record_path(output), encoding="utf-8") as stream:
            record = json.load(stream)
    except (OSError, ValueError):
        return None
    known = isinstance(record, dict) and record.get("format") == FORMAT and record.get("version") == VERSION
    return record if known else None


def done_before(job: Job, digests: Mapping[str, Optional[str]], output: str) -> Optional[Dict[str, Any]]:
    """The record of a job that needs not be done again: output and record exist, row and files are as they were."""
    record = read_record(output)
    if record is None or not os.path.isfile(output) or record.get("state") not in (DONE, PARTLY):
        return None
    return record if record.get("job") == job.task() and record.get("sha256") == dict(digests) else None
