# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text, JSON and YAML of layups and material cards, with errors that name the file and the place."""

import importlib
import json
from typing import Any, Dict, List, Tuple

from ..replacing import FileError, replacing
from .errors import LayupError, Problem, quoted


def read_text(path: str) -> str:
    """The text of a UTF-8 file, without a byte order mark. Raises LayupError when it cannot be read."""
    try:
        with open(path, encoding="utf-8-sig", newline="") as stream:
            return stream.read()
    except OSError as error:
        raise LayupError(path, [Problem("", error.strerror or str(error), "a file that can be read")]) from error
    except UnicodeDecodeError as error:
        found = f"byte 0x{error.object[error.start]:02x} at position {error.start}"
        raise LayupError(path, [Problem("", found, "text in UTF-8; save the file as CSV UTF-8")]) from error


def write_text(path: str, text: str) -> None:
    """Writes a UTF-8 file in one step. Raises LayupError when it cannot be written."""
    try:
        with replacing(path) as temporary:
            with open(temporary, "w", encoding="utf-8", newline="") as stream:
                stream.write(text)
    except FileError as error:
        reason = str(error).replace(f"{path}: ", "", 1).rstrip(".")
        raise LayupError(path, [Problem("", reason, "a file that can be written")]) from error


def parse_json(text: str, source: str) -> Any:
    """The content of a JSON text. Raises LayupError: it is none, holds NaN or infinity, or a key twice."""
    try:
        return json.loads(text, object_pairs_hook=_unique_keys, parse_constant=_no_constant)
    except json.JSONDecodeError as error:
        place = Problem(f"column {error.colno}", error.msg.lower(), "JSON", error.lineno, "line")
        raise LayupError(source, [place]) from error
    except RecursionError as error:
        raise LayupError(source, [Problem("", "too many levels", "JSON of a layup")]) from error
    except _Refused as error:
        raise LayupError(source, [Problem("", str(error), "JSON with every key once")]) from error


def parse_yaml(text: str, source: str) -> Any:
    """The content of a YAML text, every scalar as text: what "no" or "010" means is the field's business.

    Raises LayupError: it is no YAML, holds a key twice, or PyYAML is missing.
    """
    yaml = _yaml(source)

    class Loader(yaml.BaseLoader):  # type: ignore[misc, name-defined]
        """Texts only, and no key twice."""

        def construct_mapping(self, node: Any, deep: bool = False) -> Dict[Any, Any]:
            return _unique_keys(
                [(self.construct_object(key, True), self.construct_object(value, True)) for key, value in node.value]
            )

    try:
        return yaml.load(text, Loader)
    except (yaml.YAMLError, _Refused, TypeError, RecursionError) as error:
        raise LayupError(source, [_yaml_problem(error)]) from error


def dump_yaml(content: Any, source: str) -> str:
    """YAML text in the order of the content."""
    dumped: str = _yaml(source).safe_dump(content, sort_keys=False, allow_unicode=True, width=120)
    return dumped


def _yaml(source: str) -> Any:
    try:
        return importlib.import_module("yaml")
    except ImportError as error:
        expected = "PyYAML for it (on Debian: apt-get install python3-yaml), or a .json file"
        raise LayupError(source, [Problem("", "a YAML file", expected)]) from error


def _yaml_problem(error: Exception) -> Problem:
    mark = getattr(error, "problem_mark", None)
    found = str(getattr(error, "problem", None) or error).splitlines()[0]
    if mark is None:
        return Problem("", found, "YAML with every key once")
    return Problem(f"column {mark.column + 1}", found, "YAML", mark.line + 1, "line")


class _Refused(Exception):
    """Valid syntax that would not be read as it is meant."""


def _unique_keys(pairs: List[Tuple[Any, Any]]) -> Dict[Any, Any]:
    result: Dict[Any, Any] = {}
    for key, value in pairs:
        if key in result:
            raise _Refused(f"the key {quoted(key)} twice")
        result[key] = value
    return result


def _no_constant(constant: str) -> Any:
    raise _Refused(f"{constant}, which is no number,")
