# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Ply Stack"."""

from typing import Any, List, Optional

import FreeCAD as App

from ...features.layup import LayupFeature
from ...features.ply_stack import add_ply_stack, link_boundaries, link_rosettes, set_base
from ...features.rosette import RosetteFeature
from .. import preferences
from ..selection import Link, selected_faces
from .base import Command, all_of, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class PlyStackCommand(Command):
    """Lays the plies of a layup on the selected face and opens the task panel."""

    NAME = "LaminateOffset_PlyStack"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_PlyStack", "Ply Stack")
    TIP = QT_TRANSLATE_NOOP("LaminateOffset_PlyStack", "Lays the plies of a layup on the selected face")
    ACCEL = "L, P"

    def fits(self) -> bool:
        """A face or a layup is selected, or nothing is."""
        import FreeCADGui

        return bool(selected_faces() or selected_of(LayupFeature)) or not FreeCADGui.Selection.hasSelection()

    def run(self, doc: Any) -> None:
        """Opens the panel on a new stack; OK keeps it, Cancel takes it back."""
        from ..panels.ply_stack import open_new

        layups = selected_of(LayupFeature) or all_of(LayupFeature, doc)
        open_new(self.create(selected_faces(), layups[-1] if layups else None, doc))

    @staticmethod
    def create(links: List[Link], layup: Optional[Any], doc: Any) -> Any:
        """A stack of a layup object on the first linked face, not yet computed."""
        feature = add_ply_stack(doc)
        feature.Tolerance = preferences.tolerance()
        feature.MaxDegree = preferences.max_degree()
        feature.DropOff = preferences.drop_off_ratio()
        feature.Layup = layup
        link_boundaries(feature)
        link_rosettes(feature)
        rosettes = all_of(RosetteFeature, doc)
        feature.Rosette = rosettes[0] if len(rosettes) == 1 else None
        if links:
            set_base(feature, links[0][0], links[0][1][0])
        return feature
