# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles in the 3-D view, drawn in front of the surface that they lie on and never picked."""

from typing import Any, Optional, Sequence

Colour = Any  # red, green, blue from 0 to 1

_NEARER = -2.0


def triangles(points: Sequence[Any], corners: Sequence[int], colours: Optional[Sequence[Colour]] = None) -> Any:
    """A node with triangles; what is put before their first child decides their look.

    points: [mm], vectors or rows of an array. corners: three of them for every triangle. colours: of the points.
    """
    from pivy import coin

    node, style, hints = coin.SoSeparator(), coin.SoPickStyle(), coin.SoShapeHints()
    shift, place, faces = coin.SoPolygonOffset(), coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    style.style = coin.SoPickStyle.UNPICKABLE
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE  # and no solid: both sides are seen and lit
    shift.factor = shift.units = _NEARER
    place.point.setValues(0, len(points), [tuple(point) for point in points])
    indices = [index for start in range(0, len(corners), 3) for index in (*corners[start : start + 3], -1)]
    faces.coordIndex.setValues(0, len(indices), indices)
    for part in (style, hints, shift, *_paint(colours), place, faces):
        node.addChild(part)
    return node


def _paint(colours: Optional[Sequence[Colour]]) -> Sequence[Any]:
    from pivy import coin

    if colours is None:
        return ()
    paint, bind = coin.SoMaterial(), coin.SoMaterialBinding()
    paint.diffuseColor.setValues(0, len(colours), list(colours))
    bind.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    return (paint, bind)
