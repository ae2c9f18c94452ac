# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands, in toolbar order."""

from typing import List

import FreeCAD as App

from .core_sample import CoreSampleCommand
from .curvature_map import CurvatureMapCommand
from .deviation_map import DeviationMapCommand
from .export_stack import ExportPlyBookCommand, ExportStackCommand
from .exploded_view import ExplodedViewCommand
from .extend_face import ExtendFaceCommand
from .layup import ExportLayupCommand, ImportLayupCommand, LayupCommand
from .offset_face import OffsetFaceCommand
from .offset_limits import OffsetLimitsCommand
from .ply_stack import PlyStackCommand
from .rosette import RosetteCommand
from .stack_section import StackSectionCommand

QT_TRANSLATE_NOOP = App.Qt.QT_TRANSLATE_NOOP

#: Of toolbar and menu; FreeCAD translates it itself.
TITLE = QT_TRANSLATE_NOOP("Workbench", "Laminate Offset")

#: Between groups stands None.
_COMMANDS = (
    OffsetFaceCommand,
    ExtendFaceCommand,
    OffsetLimitsCommand,
    CurvatureMapCommand,
    DeviationMapCommand,
    None,
    LayupCommand,
    ImportLayupCommand,
    ExportLayupCommand,
    None,
    RosetteCommand,
    PlyStackCommand,
    CoreSampleCommand,
    StackSectionCommand,
    ExplodedViewCommand,
    ExportStackCommand,
    ExportPlyBookCommand,
)


def names() -> List[str]:
    """Names under which the commands are known to FreeCAD."""
    return [command.NAME for command in _COMMANDS if command is not None]


def layout() -> List[str]:
    """The same with separators between the groups, for toolbar and menu."""
    return ["Separator" if command is None else command.NAME for command in _COMMANDS]


def active_names() -> List[str]:
    """Names of the commands that can do something now."""
    return [command.NAME for command in _COMMANDS if command is not None and command().IsActive()]


def register() -> List[str]:
    """Adds the commands to FreeCAD. Returns their layout."""
    import FreeCADGui

    for command in _COMMANDS:
        if command is not None:
            FreeCADGui.addCommand(command.NAME, command())
    return layout()
