# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read by FreeCAD at start, with and without the GUI: tells it of our tests, for its test workbench and `freecad -t`."""

import FreeCAD

FreeCAD.__unit_test__ += ["TestLaminateOffset"]
