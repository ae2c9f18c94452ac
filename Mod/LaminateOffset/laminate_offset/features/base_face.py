# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a link with sub-elements to faces in the document's global frame, and back into a container's frame.

A link is a pair (object, sub). sub is the path FreeCAD's selection gives, e.g. "Face1", or "Body.Pad.Face1" below a
container. A path that starts at the outermost container carries every placement on its way, and makes the offset
depend on each of them.
"""

from typing import Any, Iterable, List, Sequence, Tuple

import FreeCAD as App
import Part


class BaseFaceError(RuntimeError):
    """The base link does not lead to a face. status and stage are those of the engine's vocabulary."""

    stage = "input"

    def __init__(self, status: str, message: str):
        super().__init__(message)
        self.status = status
        self.message = message


def element(sub: str) -> str:
    """The last part of a path: element("Body.Pad.Face1") is "Face1"."""
    return sub.rsplit(".", 1)[-1]


def is_face(sub: str) -> bool:
    """Whether a path ends at a face."""
    return element(sub).startswith("Face")


def describe(base: Any, sub: str) -> str:
    """Label and element for the user, e.g. "Pad: Face1" for the path "Body.Pad.Face1"."""
    owner = base.getSubObject(sub, 1) or base
    return f"{owner.Label}: {element(sub)}"


def rooted(base: Any, sub: str) -> Tuple[Any, str]:
    """The same face reached from the outermost App::Part or Body that holds base."""
    container = base.getParentGeoFeatureGroup()
    while container is not None:
        base, sub = container, f"{base.Name}.{sub}"
        container = base.getParentGeoFeatureGroup()
    return base, sub


def global_face(base: Any, sub: str) -> Any:
    """The Part.Face at (base, sub) in the document's global frame [mm]. Raises BaseFaceError."""
    shape = global_shape(base, sub)
    if shape.ShapeType != "Face":
        raise BaseFaceError("not-a-face", f"{describe(base, sub)} is not a face; pick a face.")
    return shape


def global_shape(base: Any, sub: str) -> Any:
    """The shape at (base, sub) in the document's global frame [mm]. Raises BaseFaceError where there is none."""
    try:
        shape = base.getSubObject(sub)
    except (Part.OCCError, ValueError, AttributeError, IndexError) as error:
        raise _missing(base, sub) from error
    if shape is None or shape.isNull():
        raise _missing(base, sub)
    placement = container_placement(base)
    if not placement.isIdentity():
        shape.Placement = placement.multiply(shape.Placement)  # of this handle only; the geometry stays shared
    return shape


def links_of(value: Any) -> List[Tuple[Any, List[str]]]:
    """(object, paths) for every object of a link with sub-elements, of one object or of several; [] when unset."""
    if not value:
        return []
    pairs = value if isinstance(value, list) else [value]
    links: List[Tuple[Any, List[str]]] = []
    for base, subs in pairs:
        paths = [sub for sub in ([subs] if isinstance(subs, str) else subs) if sub]
        if base is not None and links and links[-1][0] == base:
            links[-1][1].extend(paths)
        elif base is not None:
            links.append((base, paths))
    return links


def rooted_links(links: Iterable[Tuple[Any, Iterable[str]]]) -> List[Tuple[Any, str]]:
    """Each linked face from its outermost container, so that moving any container moves what depends on it."""
    faces = [rooted(base, sub) for base, subs in links for sub in subs]
    return [face for index, face in enumerate(faces) if face not in faces[:index]]


def linked_faces(value: Any) -> List[Tuple[str, Any]]:
    """(name for messages, Part.Face) of every face of a link. Raises BaseFaceError when it leads to none."""
    links = links_of(value)
    if not links:
        raise BaseFaceError("null-shape", "No base face is set; edit the object and pick a face.")
    faces = []
    for base, subs in links:
        if not subs:
            raise BaseFaceError("null-shape", f"No face of {base.Label} is named; edit the object and pick a face.")
        for sub in subs:
            name = sub if len(links) == 1 else describe(base, sub)
            faces.append((name, global_face(base, sub)))
    return faces


def container_placement(obj: Any) -> Any:
    """Global placement of the App::Part or Body that holds obj; identity at the document's top level."""
    container = obj.getParentGeoFeatureGroup()
    return App.Placement() if container is None else container.getGlobalPlacement()


def place_result(feature: Any, faces: Sequence[Any]) -> None:
    """Gives feature its shape from shapes in the global frame, expressed in the frame of feature's container.

    While an object recomputes FreeCAD replaces the location of an assigned shape by the object's Placement, so the
    location is handed over as the Placement.
    """
    shape = faces[0] if len(faces) == 1 else Part.Compound(list(faces))
    shape = _moved(shape, container_placement(feature).inverse())
    placement = shape.Placement
    feature.Shape = shape
    feature.Placement = placement


def _moved(shape: Any, placement: Any) -> Any:
    if placement.isIdentity():
        return shape
    moved = shape.copy()
    moved.Placement = placement.multiply(shape.Placement)
    return moved


def _missing(base: Any, sub: str) -> BaseFaceError:
    return BaseFaceError(
        "null-shape",
        f"There is no {describe(base, sub)}; the base may have changed. Edit the object and pick the face again.",
    )
