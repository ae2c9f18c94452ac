# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups: materials, plies and how they are stacked, in tables, documents and shorthand. Needs nothing of FreeCAD."""

from .cards import materials, read_material
from .errors import LayupError, Problem
from .files import read_layup
from .model import Layup, Material, PhysicalPly, Ply
from .notation import layup_from_notation

__all__ = [
    "Layup",
    "LayupError",
    "Material",
    "PhysicalPly",
    "Ply",
    "Problem",
    "layup_from_notation",
    "materials",
    "read_layup",
    "read_material",
]
