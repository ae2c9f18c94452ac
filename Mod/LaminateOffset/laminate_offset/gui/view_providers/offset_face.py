# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an offset face looks, and its editing by double click."""

from ...view_settings import OFFSET_LOOK
from .base import ResultViewProvider


class OffsetFaceViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_OffsetFace"
    PANEL = "offset_face"
    LOOK = OFFSET_LOOK
