# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which file a stack becomes: the name's ending decides."""

import os
from typing import TYPE_CHECKING, Callable, Dict

from ..files import format_of, write_shape
from ..replacing import FileError
from .book import export_ply_book
from .calculix import export_calculix
from .composite_cae import export_composite_cae
from .document import write_document
from .parts import assembly_name
from .step import write_step
from .table import write_table

if TYPE_CHECKING:
    from ..stack import PlyStack

# Endings of files that hold no shapes of CAD.
WRITERS: "Dict[str, Callable[[PlyStack, str], None]]" = {
    ".csv": write_table,
    ".html": export_ply_book,
    ".htm": export_ply_book,
    ".inp": export_calculix,
    ".h5": export_composite_cae,
    ".hdf5": export_composite_cae,
}
FORMATS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd", *WRITERS)


def export_stack(stack: "PlyStack", path: str, solids: bool = False, schema: str = "AP214") -> None:
    """Writes a stack; see PlyStack.export."""
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in FORMATS:
        raise FileError(f"{path}: '{ending}' is not a known format of stacks; use one of {', '.join(FORMATS)}.")
    if ending in WRITERS:
        WRITERS[ending](stack, path)
    elif format_of(path) == "STEP":
        write_step(stack, path, solids, schema)
    elif format_of(path) == "FCStd":
        write_document(stack, path, solids)
    else:
        write_shape(stack.to_shape(solids), path, assembly_name(stack))
