# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ply stacks as files: one file here for each kind.

A stack here is a PlyStack. Every file is written in one step, so that there is never half of one.
"""

from .book import export_ply_book
from .calculix import export_calculix
from .composite_cae import export_composite_cae
from .formats import FORMATS, export_stack

__all__ = ["FORMATS", "export_calculix", "export_composite_cae", "export_ply_book", "export_stack"]
