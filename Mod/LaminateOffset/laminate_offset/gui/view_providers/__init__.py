# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the document objects look and what a double click on them does."""

import importlib
from typing import Any


def attach_missing(vobj: Any, kind: Any) -> None:
    """Makes the view provider of a new object, or of one from a document that never saw the GUI.

    kind: the laminate_offset.view_settings.ViewProvider that names its class.
    """
    provider = getattr(importlib.import_module(kind.module), kind.name)
    if not isinstance(vobj.Proxy, provider):
        provider(vobj)
        vobj.Visibility = True  # FreeCAD hides what comes without view settings


def restored(vobj: Any, kind: Any) -> None:
    """Makes the view provider that is missing; others draw what needs the whole document."""
    attach_missing(vobj, kind)
    vobj.Proxy.restored(vobj)
