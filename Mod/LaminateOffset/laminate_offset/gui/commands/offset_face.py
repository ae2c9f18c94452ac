# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Offset Face"."""

from typing import Any, List

import FreeCAD as App

from ...features.offset_face import add_offset_face, set_base
from ..selection import Link, selected_faces

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class OffsetFaceCommand:
    """Makes an offset of the selected faces and opens its task panel."""

    NAME = "LaminateOffset_OffsetFace"

    def GetResources(self) -> dict:
        """Icon, texts and shortcut for FreeCAD."""
        return {
            "Pixmap": self.NAME,
            "MenuText": QT_TRANSLATE_NOOP("LaminateOffset_OffsetFace", "Offset Face"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "LaminateOffset_OffsetFace",
                "Offsets the selected faces by a constant distance along their normals, within a tolerance",
            ),
            "Accel": "L, O",
        }

    def IsActive(self) -> bool:
        """There is a document, and no task panel that would be in the way."""
        import FreeCADGui

        return App.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Opens the panel on new offsets; OK keeps them, Cancel takes them back."""
        from ..panels.offset_face import open_new

        doc = App.ActiveDocument
        links = selected_faces()
        doc.openTransaction("Offset Face")
        try:
            open_new(doc, self.create(links, doc))
        except Exception:
            doc.abortTransaction()
            raise

    @staticmethod
    def create(links: List[Link], doc: Any) -> List[Any]:
        """One offset object per link, not yet computed; an object without a base when there is no link."""
        features = []
        for base, subs in links or [(None, [])]:
            feature = add_offset_face(doc)
            if base is not None:
                set_base(feature, base, subs)
            features.append(feature)
        return features
