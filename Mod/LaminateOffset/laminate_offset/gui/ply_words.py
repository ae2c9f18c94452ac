# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of plies, written beside them in the 3-D view."""

from typing import Any, List, Sequence, Tuple

_SIZE = 12.0
_COLOUR = (0.10, 0.10, 0.12)
#: More names would cover each other: then only every second, third... is written.
_MOST = 40


def ply_words(places: Sequence[Tuple[Any, str]]) -> Any:
    """A node with a word at every place [mm], which cannot be picked; of very many plies only some are named."""
    from pivy import coin

    node, style = coin.SoSeparator(), coin.SoPickStyle()
    light, paint, font = coin.SoLightModel(), coin.SoBaseColor(), coin.SoFont()
    style.style = coin.SoPickStyle.UNPICKABLE
    light.model = coin.SoLightModel.BASE_COLOR
    paint.rgb = _COLOUR
    font.name, font.size = "sans", _SIZE
    for part in (style, light, paint, font):
        node.addChild(part)
    for point, word in _thinned(list(places)):
        part, place, text = coin.SoSeparator(), coin.SoTranslation(), coin.SoText2()
        place.translation.setValue(*(float(value) for value in point))
        text.string = f" {word}"
        part.addChild(place)
        part.addChild(text)
        node.addChild(part)
    return node


def ply_word(name: str, angle: float) -> str:
    """What is written beside a ply, e.g. "P1 45 deg" with the sign for degrees."""
    return f"{name} {angle:g}\N{DEGREE SIGN}"


def _thinned(places: List[Tuple[Any, str]]) -> List[Tuple[Any, str]]:
    return places[:: -(-len(places) // _MOST) or 1]
