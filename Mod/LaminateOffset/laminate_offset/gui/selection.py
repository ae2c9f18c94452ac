# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has selected or picks, as links to faces."""

from typing import Any, Callable, List, Tuple

import FreeCAD as App

from ..features.base_face import is_face

#: An object and paths of its faces, e.g. (Part, ["Body.Pad.Face1"]).
Link = Tuple[Any, List[str]]


def selected_faces() -> List[Link]:
    """The selected faces, one link per top-level object, with paths through all containers.

    An object that consists of a single face counts as that face.
    """
    import FreeCADGui

    links = []
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        subs = [sub for sub in selected.SubElementNames if is_face(sub)]
        if not subs:
            paths = selected.SubElementNames or [""]
            subs = [path + "Face1" for path in paths if _is_single_face(selected.Object, path)]
        if subs:
            links.append((selected.Object, subs))
    return links


def _is_single_face(obj: Any, path: str) -> bool:
    if path and not path.endswith("."):
        return False
    shape = obj.getSubObject(path)
    return getattr(shape, "Faces", None) is not None and len(shape.Faces) == 1


class FaceGate:
    """Lets the user pick faces only, and none that depend on the objects being edited."""

    def __init__(self, features: List[Any]):
        self._excluded = set(features)
        for feature in features:
            self._excluded.update(feature.InListRecursive)

    def allow(self, _doc: Any, obj: Any, sub: str) -> bool:
        """Called by FreeCAD for whatever is under the mouse."""
        return is_face(sub) and obj not in self._excluded


class FacePicker:
    """While started, hands every picked face to a callback as (object, path)."""

    def __init__(self, features: List[Any], picked: Callable[[Any, str], None]):
        self._features = features
        self._picked = picked
        self._running = False

    def start(self) -> None:
        """Only faces can be picked from now on."""
        import FreeCADGui

        if not self._running:
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelectionGate(FaceGate(self._features))
            FreeCADGui.Selection.addObserver(self, 0)
            self._running = True

    def stop(self) -> None:
        """Back to free selection. Harmless when not started."""
        import FreeCADGui

        if self._running:
            FreeCADGui.Selection.removeObserver(self)
            FreeCADGui.Selection.removeSelectionGate()
            self._running = False

    def addSelection(self, doc: str, obj: str, sub: str, _point: Any) -> None:
        """Called by FreeCAD for each addition to the selection."""
        if is_face(sub):
            self._picked(App.getDocument(doc).getObject(obj), sub)


class ElementPicker:
    """While started, hands every picked sub-element that fits to a callback as (object, path, point in mm)."""

    def __init__(self, features: List[Any], fits: Callable[[Any, str], bool], picked: Callable[[Any, str, Any], None]):
        self._excluded = set(features)
        for feature in features:
            self._excluded.update(feature.InListRecursive)
        self._fits = fits
        self._picked = picked
        self._running = False

    def start(self) -> None:
        """Only what fits can be picked from now on."""
        import FreeCADGui

        if not self._running:
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelectionGate(self)
            FreeCADGui.Selection.addObserver(self, 0)
            self._running = True

    def stop(self) -> None:
        """Back to free selection. Harmless when not started."""
        import FreeCADGui

        if self._running:
            FreeCADGui.Selection.removeObserver(self)
            FreeCADGui.Selection.removeSelectionGate()
            self._running = False

    def allow(self, _doc: Any, obj: Any, sub: str) -> bool:
        """Called by FreeCAD for whatever is under the mouse."""
        return obj not in self._excluded and self._fits(obj, sub)

    def addSelection(self, doc: str, obj: str, sub: str, point: Any) -> None:
        """Called by FreeCAD for each addition to the selection."""
        picked = App.getDocument(doc).getObject(obj)
        if self.allow(None, picked, sub):
            self._picked(picked, sub, point)


class PointPicker:
    """While started, hands every picked point to a callback as (object, point in mm)."""

    def __init__(self, picked: Callable[[Any, Any], None]):
        self._picked = picked
        self._running = False

    def start(self) -> None:
        """Points are heeded from now on."""
        import FreeCADGui

        if not self._running:
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addObserver(self, 0)
            self._running = True

    def stop(self) -> None:
        """Points are no longer heeded. Harmless when not started."""
        import FreeCADGui

        if self._running:
            FreeCADGui.Selection.removeObserver(self)
            self._running = False

    def addSelection(self, doc: str, obj: str, sub: str, point: Any) -> None:
        """Called by FreeCAD for each addition to the selection; the point is the origin when it was not the mouse."""
        if sub:
            self._picked(App.getDocument(doc).getObject(obj), point)
