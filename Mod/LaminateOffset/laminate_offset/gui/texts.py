# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts in the user's language."""

import FreeCAD as App


def translate(context: str, text: str) -> str:
    """The text in the language of FreeCAD's GUI; English where there is no translation."""
    return str(App.Qt.translate(context, text))
