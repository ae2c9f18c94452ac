# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the add-on's icons, forms and translations are."""

import os

import FreeCADGui

_ROOT = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "resources")


def icon(name: str) -> str:
    """Path of an icon, e.g. icon("LaminateOffset_OffsetFace")."""
    return os.path.join(_ROOT, "icons", f"{name}.svg")


def form(name: str) -> str:
    """Path of a Qt Designer form, e.g. form("OffsetFacePanel")."""
    return os.path.join(_ROOT, "ui", f"{name}.ui")


def register() -> None:
    """Tells FreeCAD where icons, translations and the page of preferences are."""
    FreeCADGui.addIconPath(os.path.join(_ROOT, "icons"))
    FreeCADGui.addLanguagePath(os.path.join(_ROOT, "translations"))
    FreeCADGui.updateLocale()
    FreeCADGui.addPreferencePage(form("PreferencesPage"), "Laminate Offset")
