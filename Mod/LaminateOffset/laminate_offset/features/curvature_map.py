# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near a wanted distance is to the curvature limit, all over faces: from their principal curvatures."""

import math
from typing import Any, Iterable, List, NamedTuple, Optional, Tuple, Union

import FreeCAD as App
import numpy

import laminate_offset as lo

from .. import _core
from ..view_settings import ViewProvider
from . import progress
from .base_face import linked_faces, rooted_links
from .fold_region import use_of_limit
from .outcome import Feature, accept, add_feature
from .properties import HIDDEN, READ_ONLY, Property
from .trimmed_grid import trimmed_grid

#: What the colours stand for.
SHOWN = ["use of the limit", "limit outwards", "limit inwards"]


class CurvatureSamples(NamedTuple):
    """Triangles of faces, with their principal curvatures.

    Attributes:
        points: array (n, 3) [mm].
        triangles: array (m, 3), rows of `points`.
        curvatures: array (n, 2) [1/mm], lowest and highest, positive where the face bends towards its outward normal.
    """

    points: Any
    triangles: Any
    curvatures: Any


class CurvatureMapFeature(Feature):
    """Proxy of the App::FeaturePython object. The samples are properties, so that a saved map shows what was seen."""

    VIEW_PROVIDER = ViewProvider("laminate_offset.gui.view_providers.curvature_map", "CurvatureMapViewProvider", None)
    PROPERTIES = (
        Property("App::PropertyLinkSubList", "Base", "Map", "The faces"),
        Property(
            "App::PropertyDistance", "Distance", "Map", "The wanted distance, signed along the outward normal", 1.0
        ),
        Property("App::PropertyEnumeration", "Shows", "Map", "What the colours stand for", SHOWN),
        Property(
            "App::PropertyIntegerConstraint", "Cells", "Map", "Samples along each parameter of a face", (64, 8, 500, 8)
        ),
        Property(
            "App::PropertyFloat", "LargestUse", "Report", "Distance over limit where that is largest", 0.0, READ_ONLY
        ),
        Property("App::PropertyArea", "FoldedArea", "Report", "Area of the faces whose offset folds", 0.0, READ_ONLY),
        Property(
            "App::PropertyDistance", "Inwards", "Report", "Tightest limit seen inwards; nan: none", math.nan, READ_ONLY
        ),
        Property(
            "App::PropertyDistance",
            "Outwards",
            "Report",
            "Tightest limit seen outwards; nan: none",
            math.nan,
            READ_ONLY,
        ),
        Property("App::PropertyVectorList", "Points", "Map", "The samples' places", [], READ_ONLY | HIDDEN),
        Property("App::PropertyIntegerList", "Corners", "Map", "Three samples a triangle", [], READ_ONLY | HIDDEN),
        Property("App::PropertyFloatList", "Lowest", "Map", "Curvatures of the samples", [], READ_ONLY | HIDDEN),
        Property("App::PropertyFloatList", "Highest", "Map", "Curvatures of the samples", [], READ_ONLY | HIDDEN),
    )

    def compute(self, obj: Any) -> None:
        """Samples the faces anew."""
        faces, cells = linked_faces(obj.Base), obj.Cells
        samples = progress.run(obj.Label, lambda report: _sample_all(faces, cells, report))
        share = use_of_limit(samples.curvatures, obj.Distance.Value)
        obj.LargestUse, obj.FoldedArea = float(share.max(initial=0.0)), _area(samples, share >= 1.0)
        obj.Inwards, obj.Outwards = _tightest(samples.curvatures)
        obj.Points = [App.Vector(*point) for point in samples.points]
        obj.Corners = samples.triangles.ravel().tolist()
        obj.Lowest, obj.Highest = (numpy.nan_to_num(samples.curvatures[:, side]).tolist() for side in range(2))
        accept(obj, _message(obj, len(samples.points)), [])

    def refused(self, obj: Any) -> None:
        """No figure of an older result is left standing."""
        obj.LargestUse, obj.FoldedArea = 0.0, 0.0
        obj.Inwards = obj.Outwards = math.nan


def make_curvature_map(
    base_obj: Any, sub: Union[str, Iterable[str]], distance: float = 1.0, doc: Optional[Any] = None
) -> Any:
    """Makes a map of how near a distance is to the curvature limit and recomputes it. Works with and without the GUI.

    base_obj, sub: the object and its face or faces, e.g. "Face1" or "Body.Pad.Face1" below a container.
    distance: the wanted distance [mm], signed along the outward normal.
    doc: the document that gets the object; base_obj's when omitted.
    """
    feature = add_curvature_map(doc or base_obj.Document)
    feature.Base = rooted_links([(base_obj, [sub] if isinstance(sub, str) else sub)])
    feature.Distance = distance
    feature.Document.recompute([feature])
    return feature


def add_curvature_map(doc: Any) -> Any:
    """Adds a map that has no base face yet."""
    return add_feature(doc, CurvatureMapFeature, "CurvatureMap", "App::FeaturePython")


def shown_values(feature: Any) -> Any:
    """What the colours stand for, as an array (n,) for the points: the share of the limit that the distance uses up, or the
    size of the curvature [1/mm] that limits offsets to one side (0: nothing does)."""
    curvatures = numpy.column_stack([feature.Lowest, feature.Highest])
    if feature.Shows == SHOWN[0]:
        return use_of_limit(curvatures, feature.Distance.Value)
    return use_of_limit(curvatures, 1.0 if feature.Shows == SHOWN[1] else -1.0)


def sample(face: Any, cells: int) -> CurvatureSamples:
    """Samples one face on a grid that is cut at its loops."""
    patch = trimmed_grid(face, cells)
    if not len(patch.triangles):
        return CurvatureSamples(numpy.zeros((0, 3)), patch.triangles, numpy.zeros((0, 2)))
    points = _core.evaluate_face(face, patch.uv)[0]
    return CurvatureSamples(points, patch.triangles, _core.face_curvatures(face, patch.uv))


def _sample_all(faces: List[Tuple[str, Any]], cells: int, report: Optional[progress.Report]) -> CurvatureSamples:
    parts: List[CurvatureSamples] = []
    for index, (name, face) in enumerate(faces):
        if report is not None and not report(index / len(faces)):
            raise lo.OffsetError("cancelled", "analysis", "The sampling was cancelled.")
        try:
            parts.append(sample(face, cells))
        except lo.OffsetError as error:
            error.face = name
            raise
    starts = numpy.cumsum([0] + [len(part.points) for part in parts])
    return CurvatureSamples(
        numpy.concatenate([part.points for part in parts]),
        numpy.concatenate([part.triangles + start for part, start in zip(parts, starts)]),
        numpy.concatenate([part.curvatures for part in parts]),
    )


def _area(samples: CurvatureSamples, chosen: Any) -> float:
    """Of the triangles [mm2], each by the share of its corners that are chosen."""
    a, b, c = (samples.points[samples.triangles[:, corner]] for corner in range(3))
    areas = 0.5 * numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    return float((areas * chosen[samples.triangles].mean(axis=1)).sum())


def _tightest(curvatures: Any) -> Tuple[float, float]:
    """The limits inwards and outwards [mm] of the most curved samples; NaN where nothing limits."""
    lowest = float(numpy.nan_to_num(curvatures[:, 0]).min(initial=0.0))
    highest = float(numpy.nan_to_num(curvatures[:, 1]).max(initial=0.0))
    return (1.0 / lowest if lowest < 0 else math.nan, 1.0 / highest if highest > 0 else math.nan)


def _message(obj: Any, count: int) -> str:
    text = f"{obj.Distance.Value:.6g} mm uses {100 * obj.LargestUse:.3g} % of the limit at most, at {count} points"
    if obj.LargestUse >= 1.0:
        text += f"; it folds on {obj.FoldedArea.Value:.4g} mm2"
    return text
