# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rosette as a document object: the axes that the angles of plies refer to, attached to a face, an edge, a vertex or a
coordinate system."""

from typing import Any, List, NamedTuple, Optional, Tuple

import FreeCAD as App
import Part

import laminate_offset as lo

from .. import _core
from ..rosette import SHORTEST
from ..view_settings import LIMITS_LOOK, ViewProvider
from .base_face import BaseFaceError, describe, global_shape, place_result, rooted
from .outcome import Feature, accept, add_feature
from .properties import HIDDEN, READ_ONLY, Property

_GONE = "What the rosette was attached to is gone; edit the rosette and pick again."

#: Length of the axes that are drawn, in parts of the size of what the rosette is attached to.
_SIZE = 0.12
#: Of a rosette that is attached to nothing with a size [mm].
_USUAL_SIZE = 10.0
#: The second axis is drawn shorter, the normal shorter still.
_SHORTER = (1.0, 0.6, 0.35)


class Frame(NamedTuple):
    """Where a rosette is, in the document's global frame.

    Attributes:
        origin: [mm].
        first: the first axis, of length 1.
        normal: of the face or the coordinate system, of length 1; None where there is none.
        size: of what the rosette is attached to [mm]; 0 where it has none.
    """

    origin: Any
    first: Any
    normal: Optional[Any]
    size: float


class RosetteFeature(Feature):
    """Proxy of the Part::FeaturePython object. Its shape has the axes as lines: the first, the second, the normal."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.rosette", "RosetteViewProvider", LIMITS_LOOK)
    PROPERTIES = (
        Property(
            "App::PropertyLinkSub", "Support", "Rosette", "Face, edge, vertex or coordinate system that carries it"
        ),
        Property("App::PropertyBool", "Attached", "Rosette", "Whether it was attached", False, READ_ONLY | HIDDEN),
        Property("App::PropertyVectorDistance", "Point", "Rosette", "On a face: the nearest point is the origin"),
        Property("App::PropertyVector", "Direction", "Rosette", "Of the first axis, where no edge gives it", (1, 0, 0)),
        Property("App::PropertyAngle", "Turn", "Rosette", "Of the first axis about the normal", 0.0),
        Property("App::PropertyLength", "Size", "Rosette", "Of the axes that are drawn; 0: by the support's size", 0.0),
        Property("App::PropertyVector", "Origin", "Report", "[mm]", None, READ_ONLY),
        Property("App::PropertyVector", "FirstAxis", "Report", "Of length 1", None, READ_ONLY),
    )

    def compute(self, obj: Any) -> None:
        """Finds origin and axes."""
        frame = frame_of(obj)
        place_result(obj, [Part.Compound(_axes(frame, obj.Size.Value))])
        obj.Origin, obj.FirstAxis = frame.origin, frame.first
        place, axis = (", ".join(f"{value:.4g}" for value in vector) for vector in (frame.origin, frame.first))
        accept(obj, f"first axis ({axis}) at ({place}) mm", [])


def make_rosette(
    support: Optional[Any], sub: str = "", point: Any = (0, 0, 0), direction: Any = (1, 0, 0), doc: Optional[Any] = None
) -> Any:
    """Makes a rosette and recomputes it. Works with and without the GUI.

    support, sub: an object and its "Face1", "Edge2" or "Vertex3"; "" for a coordinate system. None: attached to nothing.
    point: [mm]; on a face the nearest point is the origin. Vertices, edges (at their middle) and systems give their own.
    direction: of the first axis; edges and systems give their own.
    doc: the document that gets the object; support's when omitted.
    """
    feature = add_rosette(doc or support.Document)
    if support is not None:
        set_support(feature, support, sub)
    feature.Point, feature.Direction = App.Vector(*point), App.Vector(*direction)
    feature.Document.recompute([feature])
    return feature


def add_rosette(doc: Any) -> Any:
    """Adds a rosette that is attached to nothing yet."""
    return add_feature(doc, RosetteFeature, "Rosette")


def set_support(feature: Any, base: Any, sub: str) -> None:
    """Attaches it, rooted at the outermost container."""
    root, path = rooted(base, sub)
    feature.Support = (root, [path])
    feature.Attached = True


def rosette_of(feature: Any) -> "lo.Rosette":
    """The rosette of an object that is not refused, for everything that counts angles."""
    return lo.Rosette(tuple(feature.Origin), tuple(feature.FirstAxis))


def frame_of(feature: Any) -> Frame:
    """Where the rosette is now. Raises BaseFaceError or ValueError."""
    frame = _supported(feature)
    turn = feature.Turn.Value
    if not turn:
        return frame
    if frame.normal is None:
        raise ValueError("Without a face or a coordinate system there is no normal to turn about; set Turn to 0.")
    return frame._replace(first=App.Rotation(frame.normal, turn).multVec(frame.first))


def _supported(feature: Any) -> Frame:
    if not feature.Support and feature.Attached:  # FreeCAD drops the link to an object that is deleted
        raise BaseFaceError("null-shape", _GONE)
    if not feature.Support:
        return Frame(App.Vector(feature.Point), _unit(feature.Direction), None, 0.0)
    base, subs = feature.Support
    path = subs[0] if subs else ""
    element = path.rsplit(".", 1)[-1]
    if not element:
        return _of_system(base.getSubObject(path, 1) if path else base)
    shape = global_shape(base, path)
    size = shape.BoundBox.DiagonalLength
    if shape.ShapeType == "Face":
        return _on_face(shape, feature, size)
    if shape.ShapeType == "Edge":
        middle = 0.5 * (shape.FirstParameter + shape.LastParameter)
        along = shape.tangentAt(middle)
        return Frame(shape.valueAt(middle), along.negative() if shape.Orientation == "Reversed" else along, None, size)
    if shape.ShapeType == "Vertex":
        return Frame(shape.Point, _unit(feature.Direction), None, 0.0)
    raise BaseFaceError("not-a-face", f"{describe(base, path)} is no face, edge or vertex; pick one of these.")


def _of_system(system: Any) -> Frame:
    if system is None or not hasattr(system, "Placement"):
        raise BaseFaceError("null-shape", _GONE)
    placement = system.getGlobalPlacement()
    axes = (placement.Rotation.multVec(App.Vector(*axis)) for axis in ((1, 0, 0), (0, 0, 1)))
    return Frame(placement.Base, *axes, 0.0)


def _on_face(face: Any, feature: Any, size: float) -> Frame:
    foot = lo.nearest_point(face, [tuple(feature.Point)], trimmed=True)
    normal = App.Vector(*_core.evaluate_face(face, foot.uv)[1][0])
    wanted = _unit(feature.Direction)
    flat = wanted - normal * wanted.dot(normal)
    if flat.Length < SHORTEST:
        raise ValueError("The direction stands on the face, so it has no direction in it; choose another one.")
    return Frame(App.Vector(*foot.points[0]), flat.normalize(), normal, size)


def _unit(vector: Any) -> Any:
    if vector.Length == 0:
        raise ValueError("The direction is zero; give the rosette's first axis.")
    return App.Vector(vector).normalize()


def _axes(frame: Frame, size: float) -> List[Any]:
    """The lines that are drawn; without a normal the first axis alone."""
    length = size or _SIZE * frame.size or _USUAL_SIZE
    axes: Tuple[Any, ...] = (frame.first,)
    if frame.normal is not None:
        axes = (frame.first, frame.normal.cross(frame.first), frame.normal)
    return [Part.makeLine(frame.origin, frame.origin + axis * length * part) for axis, part in zip(axes, _SHORTER)]
