# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands "Layup", "Import Layup" and "Export Layup"."""

from typing import Any, Optional

import FreeCAD as App

from ...features.layup import LayupFeature, layup_of, make_layup
from ...features.ply_stack import PlyStackFeature
from ...layup import Layup
from .base import Command, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


class LayupCommand(Command):
    """Makes a layup and opens its table."""

    NAME = "LaminateOffset_Layup"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_Layup", "Layup")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_Layup", "Makes a layup: a table of plies with materials, angles, thicknesses"
    )
    ACCEL = "L, L"

    def run(self, doc: Any) -> None:
        """Opens the panel on a new layup; OK keeps it, Cancel takes it back."""
        from ..panels.layup import open_new

        open_new(self.create(doc))

    @staticmethod
    def create(doc: Any, layup: Optional[Layup] = None) -> Any:
        """A layup object; with one ply of carbon when no layup is given."""
        return make_layup(doc, layup)


class ImportLayupCommand(Command):
    """Makes a layup from a file."""

    NAME = "LaminateOffset_ImportLayup"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ImportLayup", "Import Layup...")
    TIP = QT_TRANSLATE_NOOP("LaminateOffset_ImportLayup", "Reads a layup table (.csv) or a whole job (.json, .yaml)")
    ACCEL = "L, I"

    def run(self, doc: Any) -> None:
        """Asks for a file; what is wrong with it is shown row by row."""
        from .layup_files import ask_for_path, shown

        path = ask_for_path()
        feature = shown(lambda: self.create(doc, path)) if path else None
        if feature is None:
            doc.abortTransaction()
        else:
            doc.commitTransaction()

    @staticmethod
    def create(doc: Any, path: str) -> Any:
        """A layup object that is named like the file. Raises LayupError."""
        from ...features.layup import import_layup

        return import_layup(doc, path)


class ExportLayupCommand(Command):
    """Writes the selected layup to a file."""

    NAME = "LaminateOffset_ExportLayup"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ExportLayup", "Export Layup...")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_ExportLayup", "Writes the selected layup as a table (.csv) or as a whole job (.json, .yaml)"
    )
    ACCEL = "L, X"

    def fits(self) -> bool:
        """One layup, or one stack with a layup, is selected."""
        return self._selected() is not None

    def Activated(self) -> None:
        """Asks for a file. The document is only read."""
        from .layup_files import ask_and_write, shown

        feature = self._selected()
        layup = None if feature is None else shown(lambda: layup_of(feature))
        if layup is not None:
            ask_and_write(layup, feature.Label)

    @staticmethod
    def create(feature: Any, path: str) -> None:
        """Writes the layup of a Layup object. Raises LayupError."""
        layup_of(feature).write(path)

    @staticmethod
    def _selected() -> Any:
        layups = selected_of(LayupFeature) or [stack.Layup for stack in selected_of(PlyStackFeature) if stack.Layup]
        return layups[0] if len(layups) == 1 else None
