# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's commands, in toolbar order."""

from typing import List

from .offset_face import OffsetFaceCommand

_COMMANDS = (OffsetFaceCommand,)


def names() -> List[str]:
    """Names under which the commands are known to FreeCAD."""
    return [command.NAME for command in _COMMANDS]


def register() -> List[str]:
    """Adds the commands to FreeCAD. Returns their names."""
    import FreeCADGui

    for command in _COMMANDS:
        FreeCADGui.addCommand(command.NAME, command())
    return names()
