# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proxies that have nothing to save: everything lasting is in the object's properties."""

from typing import Any


class StatelessProxy:
    """Answers FreeCAD's requests to save and restore, which have two names each."""

    def dumps(self) -> None:
        """Nothing to save (FreeCAD 0.21 and later)."""
        return None

    def loads(self, state: Any) -> None:
        """Nothing to restore (FreeCAD 0.21 and later)."""
        return None

    def __getstate__(self) -> None:
        """Nothing to save (FreeCAD 0.20)."""
        return None

    def __setstate__(self, state: Any) -> None:
        """Nothing to restore (FreeCAD 0.20)."""
        return None
