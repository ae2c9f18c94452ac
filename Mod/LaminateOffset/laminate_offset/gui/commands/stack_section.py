# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Stack Section"."""

from typing import Any, Optional

import FreeCAD as App

from ...features.ply_stack import PlyFeature, PlyStackFeature
from ...features.stack_section import add_stack_section, set_usual_plane
from .base import Command, all_of, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class StackSectionCommand(Command):
    """Cuts the plies of a stack by a plane."""

    NAME = "LaminateOffset_StackSection"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_StackSection", "Stack Section")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_StackSection", "Shows the cut of every ply of a stack by a plane, as thick as you like"
    )
    ACCEL = "L, T"

    def fits(self) -> bool:
        """A good stack or a ply of one is selected; or nothing is, and there is a good stack."""
        import FreeCADGui

        if FreeCADGui.Selection.hasSelection():
            return bool(_selected())
        return any(stack.Status == "ok" for stack in all_of(PlyStackFeature, App.ActiveDocument))

    def run(self, doc: Any) -> None:
        """Opens the panel on a new section; OK keeps it, Cancel takes it back."""
        from ..panels.stack_section import open_new

        open_new(self.create(doc, _selected()))

    @staticmethod
    def create(doc: Any, stack: Optional[Any] = None) -> Any:
        """A section through the middle of a stack, not yet computed; of the first good one when none is given."""
        feature = add_stack_section(doc)
        stacks = [each for each in all_of(PlyStackFeature, doc) if each.Status == "ok"]
        feature.Stack = stack or (stacks[0] if stacks else None)
        if feature.Stack is not None:
            set_usual_plane(feature)
        return feature


def _selected() -> Optional[Any]:
    stacks = selected_of(PlyStackFeature) + [ply.Stack for ply in selected_of(PlyFeature) if ply.Stack is not None]
    return next((stack for stack in stacks if stack.Status == "ok"), None)
