# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does in FreeCAD, one story a file. Each runs inside FreeCAD through scenario_runner.py."""
