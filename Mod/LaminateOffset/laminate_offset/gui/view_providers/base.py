# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the view providers of all our objects have in common."""

import importlib
from typing import Any, Optional

from .. import progress as progress_dialog
from ...features import progress
from ...features.stateless import StatelessProxy
from ...view_settings import Look
from ..refusal_mark import RefusalMark
from ..resources import icon
from ..scene import root_node

progress.install(progress_dialog.run)


class ResultViewProvider(StatelessProxy):
    """Proxy of a view provider. Colours are set once, at creation: later they are the user's."""

    #: Name of the icon in the tree.
    ICON = ""
    #: Module in gui.panels whose edit(object) opens the task panel; None: there is none.
    PANEL: Optional[str] = None
    #: Colour at creation; None for what has no shape.
    LOOK: Optional[Look] = None

    def __init__(self, vobj: Any):
        vobj.Proxy = self
        if self.LOOK is not None:
            vobj.ShapeColor = self.LOOK.colour
            vobj.Transparency = self.LOOK.transparency

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        self.Object = vobj.Object
        self._mark = RefusalMark(root_node(vobj))

    def restored(self, vobj: Any) -> None:
        """Called when a document has been opened, with all its objects."""

    def updateData(self, obj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the object has changed."""
        if prop in ("Status", "OutOfDate", "RefusedAt"):
            self._show_state(obj)

    def onChanged(self, vobj: Any, prop: str) -> None:
        """Called by FreeCAD when a property of the view provider has changed."""
        if prop == "Visibility" and hasattr(self, "_mark"):
            self._show_state(vobj.Object)

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon(self.ICON)

    def setEdit(self, vobj: Any, mode: int = 0) -> Any:
        """Opens the task panel; other modes (transform, colour) are FreeCAD's."""
        if mode != 0 or self.PANEL is None:
            return None
        importlib.import_module(f"laminate_offset.gui.panels.{self.PANEL}").edit(vobj.Object)
        return True

    def unsetEdit(self, _vobj: Any, mode: int = 0) -> Any:
        """Closes the task panel when editing ends from elsewhere."""
        if mode != 0 or self.PANEL is None:
            return None
        import FreeCADGui

        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, vobj: Any) -> bool:
        """Edits the object."""
        import FreeCADGui

        if self.PANEL is None:
            return False
        if not FreeCADGui.Control.activeDialog():
            FreeCADGui.getDocument(vobj.Object.Document.Name).setEdit(vobj.Object.Name)
        return True

    def _show_state(self, obj: Any) -> None:
        """Marks the place of a refusal, and an older result as out of date."""
        out_of_date = bool(getattr(obj, "OutOfDate", False))
        self._mark.show(obj if obj.ViewObject.Visibility else None)
        if hasattr(obj.ViewObject, "DrawStyle"):
            shown = obj.ViewObject.DrawStyle
            if out_of_date != (shown == "Dashed") and shown in ("Solid", "Dashed"):
                obj.ViewObject.DrawStyle = "Dashed" if out_of_date else "Solid"
