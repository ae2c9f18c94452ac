# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that needs FreeCAD's GUI: commands, task panels and view providers."""
