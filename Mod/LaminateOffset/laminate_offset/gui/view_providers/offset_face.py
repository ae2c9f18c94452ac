# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an offset face looks, and its editing by double click."""

from typing import Any

from .. import progress as progress_dialog
from ...features import progress
from ...features.stateless import StatelessProxy
from ...view_settings import OFFSET_LOOK
from ..resources import icon

progress.install(progress_dialog.dialog)


def attach_missing(vobj: Any) -> None:
    """Makes the view provider of a new object, or of one from a document that never saw the GUI."""
    if not isinstance(vobj.Proxy, OffsetFaceViewProvider):
        OffsetFaceViewProvider(vobj)
        vobj.Visibility = True  # FreeCAD hides what comes without view settings


class OffsetFaceViewProvider(StatelessProxy):
    """Proxy of the view provider. Colours are set once, at creation: later they are the user's."""

    def __init__(self, vobj: Any):
        vobj.Proxy = self
        vobj.ShapeColor = OFFSET_LOOK.colour
        vobj.Transparency = OFFSET_LOOK.transparency

    def attach(self, vobj: Any) -> None:
        """Called by FreeCAD at creation and after loading."""
        self.Object = vobj.Object

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon("LaminateOffset_OffsetFace")

    def setEdit(self, vobj: Any, mode: int = 0) -> Any:
        """Opens the task panel; other modes (transform, colour) are FreeCAD's."""
        if mode != 0:
            return None
        from ..panels.offset_face import edit

        edit(vobj.Object)
        return True

    def unsetEdit(self, _vobj: Any, mode: int = 0) -> Any:
        """Closes the task panel when editing ends from elsewhere."""
        if mode != 0:
            return None
        import FreeCADGui

        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, vobj: Any) -> bool:
        """Edits the object."""
        import FreeCADGui

        if not FreeCADGui.Control.activeDialog():
            FreeCADGui.getDocument(vobj.Object.Document.Name).setEdit(vobj.Object.Name)
        return True
