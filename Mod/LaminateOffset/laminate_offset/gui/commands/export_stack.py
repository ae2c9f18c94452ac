# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands "Export Stack" and "Export Ply Book"."""

import os
from typing import Any

import FreeCAD as App

from ...export import export_calculix, export_composite_cae, export_ply_book
from ...features import progress
from ...features.outcome import is_good
from ...features.ply_stack import (
    PlyFeature,
    PlyStackFeature,
    check_linked_rosettes,
    result_of,
    rosette_for_all,
    rosettes_for_plies,
)
from ...replacing import FileError
from ..texts import translate
from .base import Command, selected_of

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP


#: Endings of files with the axes that angles count from.
WITH_AXES = (".html", ".htm", ".inp", ".h5", ".hdf5")


class ExportStackCommand(Command):
    """Writes the selected ply stack to a file."""

    NAME = "LaminateOffset_ExportStack"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ExportStack", "Export Stack...")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_ExportStack",
        "Writes the selected stack: STEP with named plies, table, ply book, CalculiX section, HDF5 composite CAE",
    )
    ACCEL = "L, S"

    def fits(self) -> bool:
        """A good stack, or a ply of one, is selected."""
        stack = self._selected()
        return stack is not None and is_good(stack)

    def Activated(self) -> None:
        """Asks for a file. The document is only read."""
        import FreeCADGui
        from PySide import QtGui

        stack = self._selected()
        kinds = self.kinds()
        title = translate("LaminateOffset", "Export the stack")
        path, kind = QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, "", ";;".join(kinds))
        if not path:
            return
        ending = str(kind).rsplit("*", 1)[-1].rstrip(")")
        path = str(path) if os.path.splitext(path)[1] else f"{path}{ending}"
        try:
            self.create(stack, path)
        except KeyboardInterrupt:
            return  # the user has cancelled; nothing was written
        except (FileError, RuntimeError, ValueError, OSError) as error:
            QtGui.QMessageBox.critical(FreeCADGui.getMainWindow(), title, str(error))

    @staticmethod
    def kinds() -> tuple:
        """The formats, as the dialog shows them."""
        return (
            translate("LaminateOffset", "STEP, one part a ply (*.step)"),
            translate("LaminateOffset", "Table of the plies (*.csv)"),
            translate("LaminateOffset", "CalculiX shell section (*.inp)"),
            translate("LaminateOffset", "HDF5 composite CAE (*.h5)"),
            translate("LaminateOffset", "Ply book (*.html)"),
        )

    @staticmethod
    def create(stack: Any, path: str) -> None:
        """Writes a stack object; the ending of the path decides what is written. Raises FileError, ValueError or
        OffsetError."""
        if os.path.splitext(path)[1].lower() in WITH_AXES:
            check_linked_rosettes(stack)
        result, title, solids = result_of(stack), stack.Label, bool(stack.Solids)
        ending = os.path.splitext(path)[1].lower()
        if ending in (".html", ".htm"):
            axes = rosette_for_all(stack)
            progress.run(title, lambda report: export_ply_book(result, path, title, axes, progress=report))
        elif ending == ".inp":
            axes = rosette_for_all(stack)
            progress.run(title, lambda _report: export_calculix(result, path, rosette=axes))
        elif ending in (".h5", ".hdf5"):
            every = rosettes_for_plies(stack)
            progress.run(title, lambda _report: export_composite_cae(result, path, rosette=every))
        elif ending == ".fcstd":
            result.export(path, solids=solids)  # makes a document, which belongs to this thread
        else:
            progress.run(title, lambda _report: result.export(path, solids=solids))

    @staticmethod
    def _selected() -> Any:
        stacks = selected_of(PlyStackFeature) + [ply.Stack for ply in selected_of(PlyFeature)]
        return stacks[0] if stacks and all(stack == stacks[0] for stack in stacks) else None


class ExportPlyBookCommand(ExportStackCommand):
    """Writes the ply book of the selected stack."""

    NAME = "LaminateOffset_ExportPlyBook"
    MENU = QT_TRANSLATE_NOOP("LaminateOffset_ExportPlyBook", "Export Ply Book...")
    TIP = QT_TRANSLATE_NOOP(
        "LaminateOffset_ExportPlyBook", "Writes the ply book of the selected stack: a page with a picture for every ply"
    )
    ACCEL = "L, B"

    @staticmethod
    def kinds() -> tuple:
        """The one format."""
        return (translate("LaminateOffset", "Ply book (*.html)"),)
