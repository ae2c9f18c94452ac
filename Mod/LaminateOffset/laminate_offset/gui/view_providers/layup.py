# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layup in the tree, and its editing by double click. It has no shape."""

from typing import Any

from .base import ResultViewProvider


class LayupViewProvider(ResultViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_Layup"
    PANEL = "layup"

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        from pivy import coin

        super().attach(vobj)
        vobj.addDisplayMode(coin.SoGroup(), "None")  # without a display mode FreeCAD cannot show it as visible

    def getDisplayModes(self, _vobj: Any) -> list:
        """Called by FreeCAD for the list of display modes."""
        return ["None"]

    def getDefaultDisplayMode(self) -> str:
        """Called by FreeCAD at creation."""
        return "None"
