# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far an offset is from the exact offset, sampled at the corners of a mesh."""

from typing import Any, List, NamedTuple, Optional, Tuple

import FreeCAD as App
import numpy

import laminate_offset as lo

from ..view_settings import ViewProvider
from . import progress
from .base_face import BaseFaceError, container_placement, linked_faces
from .outcome import Feature, accept, add_feature
from .properties import HIDDEN, READ_ONLY, Property


#: Points that are measured between two looks at whether the user has cancelled.
_AT_ONCE = 2000


class Samples(NamedTuple):
    """A mesh of an offset.

    Attributes:
        points: array (n, 3) [mm], on the offset.
        triangles: array (m, 3), rows of `points`.
        deviations: array (n,) [mm]: distance from the base less the size of the offset's distance.
    """

    points: Any
    triangles: Any
    deviations: Any


class DeviationMapFeature(Feature):
    """Proxy of the App::FeaturePython object. The samples are properties, so that a saved map shows what was seen."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.deviation_map", "DeviationMapViewProvider", None)
    PROPERTIES = (
        Property("App::PropertyLink", "Offset", "Map", "The offset"),
        Property(
            "App::PropertyIntegerConstraint", "Triangles", "Map", "Least number of triangles", (4000, 100, 200000, 1000)
        ),
        Property("App::PropertyDistance", "Lowest", "Report", "Most negative deviation seen", 0.0, READ_ONLY),
        Property("App::PropertyDistance", "Highest", "Report", "Most positive deviation seen", 0.0, READ_ONLY),
        Property("App::PropertyVectorList", "Points", "Map", "The samples' places", [], READ_ONLY | HIDDEN),
        Property("App::PropertyFloatList", "Deviations", "Map", "The samples' values", [], READ_ONLY | HIDDEN),
        Property("App::PropertyIntegerList", "Corners", "Map", "Three samples a triangle", [], READ_ONLY | HIDDEN),
    )

    def compute(self, obj: Any) -> None:
        """Samples the offset anew."""
        pairs, least = _pairs(obj.Offset), obj.Triangles
        samples = progress.run(obj.Label, lambda report: _sample_all(pairs, least, report))
        obj.Points = [App.Vector(*point) for point in samples.points]
        obj.Corners = samples.triangles.ravel().tolist()
        obj.Lowest, obj.Highest = float(samples.deviations.min()), float(samples.deviations.max())
        obj.Deviations = samples.deviations.tolist()
        count = len(samples.points)
        accept(obj, f"deviation from {obj.Lowest.Value:.3g} to {obj.Highest.Value:.3g} mm at {count} points", [])


def make_deviation_map(offset: Any, triangles: int = 4000) -> Any:
    """Makes a map of an offset's deviation and recomputes it. Works with and without the GUI.

    offset: an offset object of the document.
    triangles: least number of triangles of the sampled mesh, 100 to 200000.
    """
    feature = add_feature(offset.Document, DeviationMapFeature, "DeviationMap", "App::FeaturePython")
    feature.Offset = offset
    feature.Triangles = triangles
    feature.Document.recompute()
    return feature


def sample(base: Any, offset: Any, distance: float, least: int, report: Optional[progress.Report] = None) -> Samples:
    """Samples one offset face.

    base: the base face. offset: its offset, or one part of it. distance: of the offset [mm]. least: number of triangles.
    Raises OffsetError when report returns False.
    """
    corners, indices = offset.tessellate(0.01 * offset.BoundBox.DiagonalLength)
    points = numpy.array([tuple(corner) for corner in corners])
    triangles = numpy.array(indices)
    while len(triangles) < least:
        points, triangles = _halved(offset, points, triangles)
    distances = []
    for start in range(0, len(points), _AT_ONCE):
        if report is not None and not report(start / len(points)):
            raise lo.OffsetError("cancelled", "analysis", "The sampling was cancelled.")
        distances.append(lo.nearest_point(base, points[start : start + _AT_ONCE]).distance)
    return Samples(points, triangles, numpy.concatenate(distances) - abs(distance))


def _sample_all(pairs: List[Tuple[Any, Any, float]], least: int, report: Optional[progress.Report]) -> Samples:
    parts = []
    for index, pair in enumerate(pairs):
        parts.append(sample(*pair, least, progress.part_of(report, index, len(pairs))))
    return joined(parts)


def joined(parts: List[Samples]) -> Samples:
    """Several meshes as one."""
    starts = numpy.cumsum([0] + [len(part.points) for part in parts])
    return Samples(
        numpy.concatenate([part.points for part in parts]),
        numpy.concatenate([part.triangles + start for part, start in zip(parts, starts)]),
        numpy.concatenate([part.deviations for part in parts]),
    )


def _halved(face: Any, points: Any, triangles: Any) -> Tuple[Any, Any]:
    """Every triangle cut into four, the new corners on the face."""
    sides = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    unique, index = numpy.unique(numpy.sort(sides, axis=1), axis=0, return_inverse=True)
    middles = lo.nearest_point(face, points[unique].mean(axis=1)).points
    ab, bc, ca = index.reshape(3, -1) + len(points)
    a, b, c = triangles.T
    cut = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return numpy.concatenate([points, middles]), numpy.concatenate([numpy.column_stack(corner) for corner in cut])


def _pairs(offset: Any) -> List[Tuple[Any, Any, float]]:
    """(base face, offset face, distance) for every face of an offset object."""
    if offset is None:
        raise BaseFaceError("null-shape", "No offset is chosen; set the property Offset.")
    if offset.Status != "ok":
        raise BaseFaceError("null-shape", f"{offset.Label} was refused: {offset.Message}")
    bases = linked_faces(offset.Base)
    parts = offset.Shape.childShapes(True, True) if len(bases) > 1 else [offset.Shape]
    placement = container_placement(offset)
    pairs = []
    for (_, base), part in zip(bases, parts):
        for face in part.Faces:
            if not placement.isIdentity():
                face.Placement = placement.multiply(face.Placement)
            pairs.append((base, face, offset.Distance.Value))
    return pairs
