# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the workbench's commands have in common."""

from typing import Any, List

import FreeCAD as App


class Command:
    """One command. create() does its work without the GUI; Activated() opens its panel on what create() made."""

    NAME = ""
    MENU = ""
    TIP = ""
    ACCEL = ""

    def GetResources(self) -> dict:
        """Icon, texts and shortcut for FreeCAD."""
        return {"Pixmap": self.NAME, "MenuText": self.MENU, "ToolTip": self.TIP, "Accel": self.ACCEL}

    def IsActive(self) -> bool:
        """There is a document, no task panel that would be in the way, and the selection fits."""
        import FreeCADGui

        return App.ActiveDocument is not None and not FreeCADGui.Control.activeDialog() and self.fits()

    def fits(self) -> bool:
        """Whether the command can do something with what is selected."""
        return True

    def Activated(self) -> None:
        """Does the work in one step of undo, which a panel may keep open."""
        doc = App.ActiveDocument
        doc.openTransaction(self.MENU)
        try:
            self.run(doc)
        except Exception:
            doc.abortTransaction()
            raise

    def run(self, doc: Any) -> None:
        """Does the work in an open transaction."""
        raise NotImplementedError


class FaceCommand(Command):
    """A command on faces: it is active where faces are selected, and where nothing is: its panel then asks for some."""

    def fits(self) -> bool:
        """Something selected is a face, or nothing is selected."""
        import FreeCADGui

        from ..selection import selected_faces

        return bool(selected_faces()) or not FreeCADGui.Selection.hasSelection()


def selected_of(kind: Any) -> List[Any]:
    """The selected objects of a kind, by the class of their proxies."""
    import FreeCADGui

    found = [entry.Object for entry in FreeCADGui.Selection.getSelectionEx()]
    return [obj for obj in found if isinstance(getattr(obj, "Proxy", None), kind)]


def all_of(kind: Any, doc: Any) -> List[Any]:
    """The document's objects of a kind, by the class of their proxies."""
    return [obj for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), kind)]
