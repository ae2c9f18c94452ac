# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adding what an object lacks: the same code serves new objects and documents of older versions."""

from typing import Any, NamedTuple, Sequence

READ_ONLY = 1
HIDDEN = 2


class Property(NamedTuple):
    """One property of a document object."""

    type: str
    name: str
    group: str
    text: str
    default: Any = None
    editor_mode: int = 0


def add_missing(obj: Any, properties: Sequence[Property]) -> None:
    """Adds each property that obj does not have yet, with its default, and sets the editor modes of all.

    A property that an older version made with another type is made anew and keeps its value.
    """
    for prop in properties:
        default = prop.default
        present = hasattr(obj, prop.name)
        if present and obj.getTypeIdOfProperty(prop.name) != prop.type:
            default = getattr(obj, prop.name)
            obj.removeProperty(prop.name)
            present = False
        if not present:
            obj.addProperty(prop.type, prop.name, prop.group, prop.text)
            if default is not None:
                setattr(obj, prop.name, default)
        obj.setEditorMode(prop.name, prop.editor_mode)
