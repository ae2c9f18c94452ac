# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs that read and write layups."""

import os
from typing import Any, Callable, Optional

import FreeCADGui
from PySide import QtGui

from ...layup import Layup, LayupError, read_layup
from ..texts import translate


def ask_for_path() -> str:
    """A file that the user chooses for reading; "" when it was cancelled."""
    title = translate("LaminateOffset", "Import a layup")
    kinds = translate("LaminateOffset", "Layups (*.csv *.json *.yaml *.yml)")
    path, _kind = QtGui.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), title, "", kinds)
    return str(path)


def ask_and_read() -> Optional[Layup]:
    """The layup in a file that the user chooses; None when it was cancelled, or is wrong, which is shown."""
    path = ask_for_path()
    return shown(lambda: read_layup(path)) if path else None


def ask_and_write(layup: Layup, name: str) -> None:
    """Writes a layup to a file that the user chooses."""
    title = translate("LaminateOffset", "Export the layup")
    kinds = ";;".join(
        (
            translate("LaminateOffset", "Whole job, YAML (*.yaml)"),
            translate("LaminateOffset", "Whole job, JSON (*.json)"),
            translate("LaminateOffset", "Table (*.csv)"),
        )
    )
    path, kind = QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, f"{name}.yaml", kinds)
    if path:
        ending = str(kind).rsplit("*", 1)[-1].rstrip(")")
        path = str(path) if os.path.splitext(path)[1] else f"{path}{ending or '.yaml'}"
        shown(lambda: layup.write(path))


def shown(action: Callable[[], Any]) -> Any:
    """What the action returns; None when it raised a LayupError, which the user then has seen."""
    try:
        return action()
    except LayupError as error:
        QtGui.QMessageBox.critical(FreeCADGui.getMainWindow(), translate("LaminateOffset", "Layup"), str(error))
        return None
