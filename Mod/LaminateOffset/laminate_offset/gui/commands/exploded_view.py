# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command "Exploded View"."""

from typing import Any, List

import FreeCAD as App

from ...features.ply_stack import PlyFeature, PlyStackFeature
from .base import Command, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class ExplodedViewCommand(Command):
    """Shows the plies of the selected stacks apart from each other, or together again. No shape is changed."""

    NAME = "LaminateOffset_ExplodedView"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ExplodedView", "Exploded View")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_ExplodedView", "Draws the plies of the selected stack apart from each other; again: together"
    )
    ACCEL = "L, V"

    def fits(self) -> bool:
        """A good stack, or a ply of one, is selected."""
        stacks = _selected()
        return bool(stacks) and all(stack.Status == "ok" for stack in stacks)

    def run(self, doc: Any) -> None:
        """Explodes the stacks that are together, and puts the others together."""
        import FreeCADGui

        stacks = _selected()
        FreeCADGui.Selection.clearSelection()  # its colour would hide the plies'
        for stack in stacks:
            self.create(stack)
        doc.commitTransaction()

    @staticmethod
    def create(stack: Any) -> None:
        """Changes how a stack object is shown. Without the GUI nothing is shown: see features.exploded for the geometry."""
        if App.GuiUp:
            from ..exploded_picture import explode, is_exploded, put_together

            (put_together if is_exploded(stack) else explode)(stack)


def _selected() -> List[Any]:
    stacks = selected_of(PlyStackFeature) + [ply.Stack for ply in selected_of(PlyFeature) if ply.Stack is not None]
    return [stack for index, stack in enumerate(stacks) if stack not in stacks[:index]]
