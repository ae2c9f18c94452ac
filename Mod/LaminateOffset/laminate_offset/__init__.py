# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constant-distance offsets of trimmed NURBS faces for FreeCAD.

    import laminate_offset as lo
    result = lo.offset_face(face, 5.0)      # mm, along the face's outward normal
    result.face                             # Part.Face; a Part.Shell where the face has creases
    result.report.to_json()

Lengths are in mm. A distance is signed along the face's outward normal, the face's orientation included: reversing
the face turns the sign. A face that cannot be offset raises OffsetError, which says why, where and what would work.
"""

import sys

from ._freecad import ensure_freecad

ensure_freecad()

try:
    from . import _core
except ImportError as error:
    raise ImportError(
        f"laminate_offset's compiled part could not be loaded by Python {sys.version_info[0]}.{sys.version_info[1]}: "
        f"{error}. Build and use it with the Python of FreeCAD (on Debian /usr/bin/python3)."
    ) from error

from .api import (
    CurveProjection,
    ExtensionResult,
    NearestPoints,
    OffsetLimits,
    OffsetResult,
    extend_face,
    nearest_point,
    offset_face,
    offset_limits,
    project_curve,
)
from .boundaries import Boundary
from .core_sample import CoreLayer, CoreSample
from .errors import OffsetError
from .exchange import select_at_import, shape_exchange
from .export import export_calculix, export_composite_cae, export_ply_book
from .layup import (
    Layup,
    LayupError,
    Material,
    PhysicalPly,
    Ply,
    layup_from_notation,
    materials,
    read_layup,
    read_material,
)
from .mass_properties import MassProperties, MaterialTotal, PlyProperties
from .report import ExtensionReport, OffsetReport
from .rosette import Rosette
from .stack import MaterialSolid, PlyStack, StackPly, stack_plies

select_at_import()

__version__: str = _core.__version__
__all__ = [
    "Boundary",
    "CoreLayer",
    "CoreSample",
    "CurveProjection",
    "ExtensionReport",
    "ExtensionResult",
    "Layup",
    "LayupError",
    "MassProperties",
    "Material",
    "MaterialSolid",
    "MaterialTotal",
    "NearestPoints",
    "OffsetError",
    "OffsetLimits",
    "OffsetReport",
    "OffsetResult",
    "PhysicalPly",
    "Ply",
    "PlyProperties",
    "PlyStack",
    "Rosette",
    "StackPly",
    "export_calculix",
    "export_composite_cae",
    "export_ply_book",
    "extend_face",
    "layup_from_notation",
    "materials",
    "nearest_point",
    "offset_face",
    "offset_limits",
    "project_curve",
    "read_layup",
    "read_material",
    "shape_exchange",
    "stack_plies",
]
