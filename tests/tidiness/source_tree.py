# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the project's own sources for the tidiness tests: which files there are, and how long functions are."""

import ast
import os
import re
import subprocess
from pathlib import Path
from typing import Iterator, List, NamedTuple, Tuple

ROOT = Path(__file__).resolve().parents[2]

SCOPE = re.compile(r"^(?:template\s*<.*>\s*)?(?:inline\s+)?(?:namespace|class|struct|union|enum|extern)\b", re.DOTALL)
LITERAL = re.compile(
    r"//[^\n]*"
    r"|/\*.*?\*/"
    r'|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"
    r"|^[ \t]*\#(?:\\\n|[^\n])*",
    re.DOTALL | re.MULTILINE,
)


class Function(NamedTuple):
    """A function's place and its number of lines from the first of its head to the closing brace."""

    place: str
    head: str
    lines: int


def source_files() -> List[Path]:
    """Returns the files of the project: those git knows or would add, else all outside build folders."""
    command = ["git", "-C", str(ROOT), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listing = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listing.returncode == 0:
        names = [ROOT / name for name in listing.stdout.decode().split("\0") if name]
        return sorted(path for path in names if path.is_file())
    found = []
    for folder, folders, names in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in ("build", ".git", "__pycache__")]
        found += [Path(folder) / name for name in names]
    return sorted(found)


def with_suffix(*suffixes: str) -> List[Path]:
    """Returns the project's files with one of the given suffixes."""
    return [path for path in source_files() if path.suffix in suffixes]


def _blank(match: "re.Match[str]") -> str:
    """Replaces a comment, literal or directive by as many line ends as it had."""
    text = match.group()
    return ("0" if text[0] in "\"'R" else " ") + "\n" * text.count("\n")


def cpp_functions(text: str, place: str) -> Iterator[Function]:
    """Yields the functions of a C++ source; a lambda counts as part of the function around it."""
    code = LITERAL.sub(_blank, text)
    scopes: List[Tuple[str, int, str]] = []  # (kind, first line, head) of every open brace
    head_start = 0
    line = 1
    for position, character in enumerate(code):
        if character == "\n":
            line += 1
        elif character == "{":
            head = code[head_start:position]
            kind = _brace_kind(head, [scope[0] for scope in scopes])
            first_line = line - head.lstrip().count("\n")
            scopes.append((kind, first_line, head.strip()))
            if kind != "initialiser":
                head_start = position + 1
        elif character == "}":
            kind, first_line, head = scopes.pop()
            if kind == "function":
                yield Function(f"{place}:{first_line}", head, line - first_line + 1)
            if kind != "initialiser":
                head_start = position + 1
        elif character == ";":
            head_start = position + 1


def _brace_kind(head: str, enclosing: List[str]) -> str:
    """Says what an opening brace begins, from the text before it."""
    if any(kind not in ("scope", "initialiser") for kind in enclosing):
        return "block"
    if "initialiser" in enclosing or re.search(r"(?:[\w>,(=]|=\s+|return\s+)\Z", head):
        return "initialiser"
    # The label of the section before a member is not part of its head.
    stripped = re.sub(r"^(?:\s*(?:public|protected|private)\s*:)+", "", head).strip()
    if SCOPE.match(stripped):
        return "scope"
    return "function" if "(" in stripped else "initialiser"


def python_functions(text: str, place: str) -> Iterator[Function]:
    """Yields the functions and methods of a Python source."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            last = node.end_lineno or node.lineno
            yield Function(f"{place}:{node.lineno}", node.name, last - node.lineno + 1)


def functions() -> List[Function]:
    """Returns every function of the project's C++ and Python sources."""
    found: List[Function] = []
    for path in with_suffix(".h", ".cpp"):
        found += cpp_functions(path.read_text(encoding="utf-8"), str(path.relative_to(ROOT)))
    for path in with_suffix(".py"):
        found += python_functions(path.read_text(encoding="utf-8"), str(path.relative_to(ROOT)))
    return found
