# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an extended face looks, and its editing by double click."""

from ...view_settings import EXTENSION_LOOK
from .base import ResultViewProvider


class ExtendFaceViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_ExtendFace"
    PANEL = "extend_face"
    LOOK = EXTENSION_LOOK
