# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups in files: the name's ending decides between tables (.csv) and whole jobs (.json, .yaml, .yml)."""

import json
import os
from typing import Iterable, Optional

from . import cards
from .documents import layup_document, read_document
from .errors import LayupError, Problem, quoted
from .model import Layup, Material
from .tables import TABLES, print_table, read_table
from .text_files import dump_yaml, parse_json, parse_yaml, read_text, write_text

ENDINGS = (".csv", ".json", ".yaml", ".yml")


def read_layup(path: str, materials: Optional[Iterable[Material]] = None) -> Layup:
    """The layup in a file.

    Args:
        path: a table (.csv, with the columns of this package or of a 3DEXPERIENCE-style stack-up file; the header tells
            which), or a whole job (.json, .yaml, .yml).
        materials: materials beside those of the library, see lo.materials(); they come before it. What a job holds
            comes before both.

    Raises:
        LayupError: the file cannot be read or is not right. The message names the file and, for every problem in it,
            the row and the column, what was found and what is expected.
    """
    path = os.fspath(path)
    ending = _ending(path)
    text = read_text(path)
    known = cards.known_materials(materials or ())
    if ending == ".csv":
        return read_table(text, path, known)
    return read_document((parse_json if ending == ".json" else parse_yaml)(text, path), path, known)


def write_layup(layup: Layup, path: str, table: str = "plain") -> None:
    """Writes a layup; see Layup.write."""
    path = os.fspath(path)
    ending = _ending(path)
    if table not in TABLES:
        raise LayupError(path, [Problem("table", quoted(table), f"one of {', '.join(TABLES)}", unit="argument")])
    write_text(path, _print(layup, path, ending, table))


def _ending(path: str) -> str:
    ending = os.path.splitext(path)[1].lower()
    if ending not in ENDINGS:
        raise LayupError(path, [Problem("", f"the ending {quoted(ending)}", f"one of {', '.join(ENDINGS)}")])
    return ending


def _print(layup: Layup, path: str, ending: str, table: str) -> str:
    if ending == ".csv":
        return print_table(layup, path, table, cards.materials())
    document = layup_document(layup)
    return json.dumps(document, indent=2, ensure_ascii=False) + "\n" if ending == ".json" else dump_yaml(document, path)
