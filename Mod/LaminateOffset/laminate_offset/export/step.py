# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stack as a STEP assembly: one part a ply, with its name and colour."""

from typing import TYPE_CHECKING

from .. import _core
from ..replacing import FileError, replacing
from .parts import assembly_name, parts_of

if TYPE_CHECKING:
    from ..stack import PlyStack

SCHEMAS = ("AP214", "AP242")


def write_step(stack: "PlyStack", path: str, solids: bool = False, schema: str = "AP214") -> None:
    """Writes the plies as parts of one assembly, in mm.

    Args:
        solids: the parts are solids, not faces.
        schema: "AP214" or "AP242".

    Raises:
        ValueError: the schema is another one.
        FileError: the file cannot be written.
    """
    if schema not in SCHEMAS:
        raise ValueError(f"schema must be one of {', '.join(SCHEMAS)}; it is {schema!r}.")
    parts = [(part.shape, part.name, part.colour) for part in parts_of(stack, solids)]
    with replacing(path) as temporary:
        try:
            _core.write_step_assembly(temporary, assembly_name(stack), parts, schema)
        except RuntimeError as error:
            raise FileError(f"{path}: cannot be written: {error}") from error
