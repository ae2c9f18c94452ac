# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ply table: CSV with one row a ply, from the tool outwards."""

import csv
from typing import TYPE_CHECKING, Any, Tuple

from ..mass_properties import PlyProperties
from ..replacing import replacing

if TYPE_CHECKING:
    from ..stack import PlyStack, StackPly

HEADER = (
    "number",
    "ply",
    "material",
    "angle_deg",
    "thickness_mm",
    "bottom_mm",
    "middle_mm",
    "top_mm",
    "boundary",
    "over_ramp",
    "area_mm2",
    "volume_mm3",
    "mass_kg",
    "certified_error_mm",
    "edge_error_mm",
)


def write_table(stack: "PlyStack", path: str) -> None:
    """Writes the table in UTF-8. Empty are a size that is not known and an error that is not proven."""
    with replacing(path) as temporary:
        with open(temporary, "w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream, lineterminator="\n")
            writer.writerow(HEADER)
            for ply, measures in zip(stack.plies, stack.mass_properties().plies):
                writer.writerow([_cell(value) for value in _row(ply, measures)])


def _row(ply: "StackPly", measures: PlyProperties) -> Tuple[Any, ...]:
    physical, row = ply.ply, ply.ply.ply
    levels = (physical.thickness, physical.bottom, physical.middle, physical.top)
    sizes = (measures.area, measures.volume, measures.mass)
    errors = (ply.report.certified_error, ply.report.edge_error)
    laid = (row.boundary, "yes" if ply.over_ramp else "no")
    return (physical.number, physical.name, row.material, row.angle, *levels, *laid, *sizes, *errors)


def _cell(value: Any) -> str:
    """The shortest text that is read back as the same value."""
    if value is None:
        return ""
    return repr(value)[:-2] if isinstance(value, float) and repr(value).endswith(".0") else str(value)
