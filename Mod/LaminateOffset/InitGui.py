# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registers the workbench. FreeCAD executes this file without __file__ and with its own local scope, so paths come
from the package and every name that a method needs is imported inside the method."""

import FreeCADGui


class LaminateOffsetWorkbench(FreeCADGui.Workbench):
    """Offset surfaces for composite lay-up."""

    MenuText = "Laminate Offset"
    ToolTip = "Offset surfaces of trimmed NURBS faces for composite lay-up"

    def __init__(self):
        import importlib.util
        import os

        # The package is only located here, not imported: a start of FreeCAD must not load the engine.
        package = importlib.util.find_spec("laminate_offset").submodule_search_locations[0]
        self.__class__.Icon = os.path.join(os.path.dirname(package), "resources", "icons", "LaminateOffset.svg")

    def Initialize(self):
        """Adds commands, toolbar and menu when the workbench is first activated."""
        import FreeCAD

        try:
            from laminate_offset.gui import commands, resources
        except ImportError as error:  # the compiled part is missing, or was built for another Python or OpenCASCADE
            from PySide import QtGui

            FreeCAD.Console.PrintError(f"Laminate Offset: {error}\n")
            QtGui.QMessageBox.critical(FreeCADGui.getMainWindow(), "Laminate Offset", str(error))
            return
        resources.register()
        layout = commands.register()
        title = commands.TITLE
        self.appendToolbar(title, layout)
        self.appendMenu(title, layout)

    def ContextMenu(self, recipient):
        """Offers what can be done with the selection, in the 3-D view and in the tree."""
        try:
            from laminate_offset.gui import commands
        except ImportError:  # told when the workbench was chosen
            return
        self.appendContextMenu("", commands.active_names())

    def GetClassName(self):
        """The C++ class behind a workbench written in Python."""
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(LaminateOffsetWorkbench())
