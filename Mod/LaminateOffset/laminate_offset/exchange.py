# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chooses, at import, the way in which shapes cross between FreeCAD and the engine."""

import math
import os
from typing import List, Sequence

import FreeCAD
import Part

from . import _core

WAYS = ("zero-copy", "binary", "brep-text")
VARIABLE = "LAMINATE_OFFSET_SHAPE_EXCHANGE"


def shape_exchange() -> str:
    """The way in use: "zero-copy" (both sides share the shape), "binary" or "brep-text" (a copy crosses).

    The first which passes its self-test at import is taken. The environment variable LAMINATE_OFFSET_SHAPE_EXCHANGE
    forces one.
    """
    return _core.shape_exchange()


def select_at_import() -> None:
    """Takes the first way that works, or the one which the environment variable names; raises ImportError if none."""
    forced = os.environ.get(VARIABLE)
    if forced is not None and forced not in WAYS:
        raise ImportError(f"{VARIABLE}={forced} is not one of {', '.join(WAYS)}; correct or unset it.")
    problems: List[str] = []
    for way in WAYS if forced is None else (forced,):
        problem = self_test(way)
        if not problem:
            _core.select_shape_exchange(way)
            return
        problems.append(f"{way}: {problem}")
    raise ImportError("No way to exchange shapes with FreeCAD works. " + "; ".join(problems))


def self_test(way: str) -> str:
    """Sends a moved, reversed face there and back. Empty text if it came back the same, otherwise what went wrong."""
    if way == "zero-copy" and Part.OCC_VERSION != _core.occt_version:
        return f"FreeCAD uses OpenCASCADE {Part.OCC_VERSION}, the engine was built for {_core.occt_version}"
    face = _test_face()
    try:
        back = _core.round_trip(face, way)
    except Exception as error:  # whatever a foreign FreeCAD raises here, the next way is tried
        return f"{type(error).__name__}: {error}"
    if way == "zero-copy":
        return "" if back.isEqual(face) else "the shape that came back is not the one sent"
    return _difference(face, back)


def _test_face() -> "Part.Face":
    face = Part.makeCylinder(10.0, 20.0).Faces[0].copy()
    face.Placement = FreeCAD.Placement(FreeCAD.Vector(1.0, 2.0, 3.0), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 30.0))
    face.reverse()
    return face


def _difference(sent: "Part.Face", back: "Part.Face") -> str:
    if back.ShapeType != "Face":
        return f"a {back.ShapeType} came back for a face"
    if back.Orientation != sent.Orientation:
        return "the orientation was lost"
    if _largest_difference(back.Placement.Matrix.A, sent.Placement.Matrix.A) > 1e-12:
        return "the placement was lost"
    if not math.isclose(back.Area, sent.Area, rel_tol=1e-12):
        return "the area changed"
    return ""


def _largest_difference(first: Sequence[float], second: Sequence[float]) -> float:
    return max(abs(a - b) for a, b in zip(first, second))
