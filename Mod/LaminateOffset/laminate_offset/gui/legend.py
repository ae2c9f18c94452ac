# SPDX-License-Identifier: LGPL-2.1-or-later
"""A colour scale with figures, fixed at the left of the 3-D view."""

from typing import Any, Sequence, Tuple

Colour = Tuple[float, float, float]

# In the view's own frame: both axes go from -1 to 1 whatever its size.
_LEFT, _WIDTH, _BOTTOM, _TOP = -0.93, 0.05, -0.45, 0.45
_BACK = (0.12, 0.12, 0.12)
_TEXT = (0.95, 0.95, 0.95)
_SIZE = 14.0


def legend(title: str, ticks: Sequence[str], colours: Sequence[Colour]) -> Any:
    """A node that draws the scale.

    title: above the scale. ticks: the figures, from the top down. colours: of as many evenly spaced places.
    """
    from pivy import coin

    outer = _unfitted()
    node = coin.SoAnnotation()
    frame, camera, light = coin.SoResetTransform(), coin.SoOrthographicCamera(), coin.SoLightModel()
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.height, camera.aspectRatio = 2.0, 1.0
    camera.position.setValue(0, 0, 1)
    camera.nearDistance, camera.farDistance = 0.0, 2.0
    light.model = coin.SoLightModel.BASE_COLOR
    for part in (style, frame, camera, light, _panel(), _bar(colours), _words(title, ticks)):
        node.addChild(part)
    outer.addChild(node)
    return outer


def _unfitted() -> Any:
    """A group whose size does not count when the view is fitted."""
    from pivy import coin

    kind = coin.SoType.fromName("SoSkipBoundingGroup")  # FreeCAD's own
    if not kind.canCreateInstance():
        return coin.SoSeparator()
    group = kind.createInstance()
    group.getField("mode").set("EXCLUDE_BBOX")
    return group


def _panel() -> Any:
    """The dark ground that makes the words legible on any background."""
    return _strip([_BACK, _BACK], _LEFT - 0.03, _WIDTH + 0.27, _BOTTOM - 0.08, _TOP + 0.22, -0.1)


def _bar(colours: Sequence[Colour]) -> Any:
    return _strip(colours, _LEFT, _WIDTH, _BOTTOM, _TOP, 0.0)


def _strip(colours: Sequence[Colour], left: float, width: float, bottom: float, top: float, depth: float) -> Any:
    """Colours from the top down, with even changes between them."""
    from pivy import coin

    node, paint, bind, corners = coin.SoSeparator(), coin.SoMaterial(), coin.SoMaterialBinding(), coin.SoCoordinate3()
    strip, hints = coin.SoQuadMesh(), coin.SoShapeHints()
    count = len(colours)
    heights = [top + (bottom - top) * index / (count - 1) for index in range(count)]
    points = [(x, height, depth) for height in heights for x in (left, left + width)]
    paint.diffuseColor.setValues(0, 2 * count, [colour for colour in colours for _ in range(2)])
    bind.value = coin.SoMaterialBinding.PER_VERTEX
    corners.point.setValues(0, len(points), points)
    strip.verticesPerRow, strip.verticesPerColumn = 2, count
    for part in (hints, paint, bind, corners, strip):
        node.addChild(part)
    return node


def _words(title: str, ticks: Sequence[str]) -> Any:
    from pivy import coin

    node, paint, font = coin.SoSeparator(), coin.SoBaseColor(), coin.SoFont()
    paint.rgb = _TEXT
    font.name, font.size = "sans", _SIZE
    node.addChild(paint)
    node.addChild(font)
    step = (_TOP - _BOTTOM) / (len(ticks) - 1)
    places = [(_LEFT, _TOP + 0.12, title)]
    places += [(_LEFT + _WIDTH + 0.02, _TOP - step * index - 0.012, tick) for index, tick in enumerate(ticks)]
    for x, y, word in places:
        part, place, text = coin.SoSeparator(), coin.SoTranslation(), coin.SoText2()
        place.translation.setValue(x, y, 0.1)
        text.string = word
        part.addChild(place)
        part.addChild(text)
        node.addChild(part)
    return node
