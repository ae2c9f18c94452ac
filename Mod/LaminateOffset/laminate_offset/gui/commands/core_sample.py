# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Core Sample"."""

from typing import Any, Optional

import FreeCAD as App

from ...features.core_sample import add_core_sample
from ...features.ply_stack import PlyFeature, PlyStackFeature
from .base import Command, all_of, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class CoreSampleCommand(Command):
    """Shows the plies that are met at a point of a stack."""

    NAME = "LaminateOffset_CoreSample"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_CoreSample", "Core Sample")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_CoreSample", "Shows which plies of a stack are met at a point, and from where to where"
    )
    ACCEL = "L, C"

    def fits(self) -> bool:
        """A stack or a ply of one is selected; or nothing is, and there is a stack."""
        import FreeCADGui

        if FreeCADGui.Selection.hasSelection():
            return bool(selected_of((PlyStackFeature, PlyFeature)))
        return bool(all_of(PlyStackFeature, App.ActiveDocument))

    def run(self, doc: Any) -> None:
        """Opens the panel on a new sample; OK keeps it, Cancel takes it back."""
        from ..panels.core_sample import open_new

        stacks = selected_of(PlyStackFeature) or [ply.Stack for ply in selected_of(PlyFeature)]
        open_new(self.create(doc, stacks[0] if stacks else None))

    @staticmethod
    def create(doc: Any, stack: Optional[Any] = None, point: Optional[Any] = None) -> Any:
        """A sample of a stack at a point [mm], not yet computed."""
        feature = add_core_sample(doc)
        feature.Stack = stack
        if point is not None:
            feature.Point = App.Vector(*point)
        return feature
