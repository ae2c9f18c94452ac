# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of an exploded stack, and how a stack is shown like that."""

from typing import Any, List, Sequence

import numpy

from ..features.base_face import container_placement
from ..features.exploded import ALONG, Sheet, exploded, usual_direction, usual_factor
from ..features.ply_stack import OUTPUTS, plies_of, ply_reports
from .lines import polylines
from .ply_words import ply_word, ply_words
from .triangles import triangles

#: Display modes of a stack.
EXPLODED, USUAL = "Exploded", "Flat Lines"


def exploded_picture(stack: Any, view: Any, colours: Sequence[Any]) -> Any:
    """A node with the plies of a stack as its view provider's properties ask for them.

    colours: of the plies, from the tool outwards.
    """
    from pivy import coin

    to_own = stack.Placement.inverse().multiply(container_placement(stack).inverse())
    node, words = coin.SoSeparator(), []
    sheets = exploded(stack, view.ExplodedFactor, view.ExplodedAlong, view.ExplodedDirection)
    for sheet, colour, report in zip(sheets, colours, ply_reports(stack)):
        own = _moved(sheet, numpy.array(to_own.toMatrix().A).reshape(4, 4))
        paint, part = coin.SoMaterial(), coin.SoSeparator()
        paint.diffuseColor = colour
        for child in (paint, triangles(own.points.tolist(), own.triangles.ravel().tolist()), polylines(own.lines)):
            part.addChild(child)
        node.addChild(part)
        words.append((own.points[own.points[:, 0].argmax()], ply_word(report["name"], report["angle"])))
    node.addChild(ply_words(words))
    return node


def is_exploded(stack: Any) -> bool:
    """Whether a stack is shown exploded."""
    return bool(stack.ViewObject.DisplayMode == EXPLODED)


def explode(stack: Any) -> None:
    """Shows a good stack exploded, as far as all plies can be told apart."""
    view = stack.ViewObject
    direction = usual_direction(stack)
    if view.ExplodedFactor == 1.0:
        view.ExplodedAlong = ALONG[0] if direction is None else ALONG[1]
        view.ExplodedDirection = direction or view.ExplodedDirection
        view.ExplodedFactor = usual_factor(stack)
    view.DisplayMode = EXPLODED
    view.Visibility = True
    for ply in plies_of(stack):
        ply.ViewObject.Visibility = False


def put_together(stack: Any) -> None:
    """Shows a stack as it is again."""
    stack.ViewObject.DisplayMode = USUAL
    stack.ViewObject.Visibility = stack.Output == OUTPUTS[0]
    for ply in plies_of(stack):
        ply.ViewObject.Visibility = True


def _moved(sheet: Sheet, matrix: Any) -> Sheet:
    """In another frame, that of a matrix (4, 4)."""

    def move(points: Any) -> Any:
        return points @ matrix[:3, :3].T + matrix[:3, 3]

    lines: List[Any] = [move(line) for line in sheet.lines]
    return Sheet(move(sheet.points), sheet.triangles, lines)
