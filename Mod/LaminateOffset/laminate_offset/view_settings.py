# SPDX-License-Identifier: LGPL-2.1-or-later
"""View settings for documents that are saved without FreeCAD's GUI.

Such a document has none of its own: FreeCAD then hides its Part features, and its offsets cannot be edited by a double
click. The settings are the part GuiDocument.xml of the FCStd file.
"""

import zipfile
from typing import Any, Mapping, NamedTuple, Optional, Tuple
from xml.sax.saxutils import quoteattr

PART = "GuiDocument.xml"


class Look(NamedTuple):
    """Colour of the faces (red, green, blue from 0 to 1) and transparency in percent."""

    colour: Tuple[float, float, float]
    transparency: int = 0


#: Of offsets: a blue that differs from FreeCAD's grey; see-through enough to show the base behind it.
OFFSET_LOOK = Look((0.36, 0.59, 0.84), 35)

#: Of extended faces: a green that differs from offsets and bases.
EXTENSION_LOOK = Look((0.45, 0.72, 0.41), 35)

#: Of marks of feasible limits and of core samples.
LIMITS_LOOK = Look((0.80, 0.30, 0.10))
SAMPLE_LOOK = Look((0.30, 0.30, 0.30))


class ViewProvider(NamedTuple):
    """Class of a kind of object's view provider, and its look; None for what has no shape of its own.

    Proxies of such objects name theirs as VIEW_PROVIDER.
    """

    module: str
    name: str
    look: Optional[Look]


def add_view_settings(path: str, document: Any, looks: Optional[Mapping[str, Look]] = None) -> None:
    """Adds view settings to the file of a document which was saved without the GUI; with the GUI it has them already.

    path: the FCStd file that `document` was saved as.
    looks: by the objects' names; the others have the look of their kind. Objects are visible or hidden as the document
    says.
    """
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as archive:
        if PART not in archive.namelist():
            archive.writestr(PART, _gui_document(document.Objects, looks or {}))


def _gui_document(objects: Any, looks: Mapping[str, Look]) -> str:
    views = "".join(_view(thing, looks.get(thing.Name)) for thing in objects)
    return (
        "<?xml version='1.0' encoding='utf-8'?>\n"
        f'<Document SchemaVersion="1"><ViewProviderData Count="{len(objects)}">{views}</ViewProviderData>'
        '<Camera settings=""/></Document>\n'
    )


def _view(thing: Any, look: Optional[Look]) -> str:
    properties = []
    provider = getattr(getattr(thing, "Proxy", None), "VIEW_PROVIDER", None)
    if provider is not None:
        # The encoded state is JSON's null: our view providers keep none.
        state = f'value="bnVsbA==" encoded="yes" module="{provider.module}" class="{provider.name}"'
        properties.append(_property("Proxy", "App::PropertyPythonObject", f"<Python {state}/>"))
        look = look or provider.look
    if look is not None:
        colour = f'<PropertyColor value="{_packed(look.colour)}"/>'
        properties.append(_property("ShapeColor", "App::PropertyColor", colour))
        transparency = f'<Integer value="{look.transparency}"/>'
        properties.append(_property("Transparency", "App::PropertyPercent", transparency))
    visible = f'<Bool value="{str(bool(thing.Visibility)).lower()}"/>'
    properties.append(_property("Visibility", "App::PropertyBool", visible))
    return (
        f'<ViewProvider name={quoteattr(thing.Name)} expanded="0">'
        f'<Properties Count="{len(properties)}">{"".join(properties)}</Properties></ViewProvider>'
    )


def _property(name: str, kind: str, value: str) -> str:
    return f'<Property name="{name}" type="{kind}">{value}</Property>'


def _packed(colour: Tuple[float, float, float]) -> int:
    """A colour as FreeCAD stores it: red, green, blue and transparency, a byte each."""
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8
