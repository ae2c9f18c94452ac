# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs at every start of FreeCAD, with or without the GUI. Being on the module path is all the add-on needs."""
