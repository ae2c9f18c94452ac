# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines in the 3-D view that cannot be picked."""

from typing import Any, Sequence

_DARK = (0.12, 0.12, 0.14)


def polylines(lines: Sequence[Any], colour: Any = _DARK, width: float = 1.0) -> Any:
    """A node with polygon lines, each an array (k, 3) [mm]."""
    from pivy import coin

    node, style, draw = coin.SoSeparator(), coin.SoPickStyle(), coin.SoDrawStyle()
    light, paint = coin.SoLightModel(), coin.SoBaseColor()
    corners, strips = coin.SoCoordinate3(), coin.SoLineSet()
    style.style = coin.SoPickStyle.UNPICKABLE
    draw.lineWidth = width
    light.model = coin.SoLightModel.BASE_COLOR
    paint.rgb = colour
    points = [tuple(point) for line in lines for point in line]
    corners.point.setValues(0, len(points), points)
    strips.numVertices.setValues(0, len(lines), [len(line) for line in lines])
    for part in (style, draw, light, paint, corners, strips):
        node.addChild(part)
    return node
