# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stack as named and coloured parts: what STEP files and documents hold."""

from typing import TYPE_CHECKING, Any, List, NamedTuple

from ..ply_colours import Colour, angle_colour

if TYPE_CHECKING:
    from ..stack import PlyStack, StackPly


class Part(NamedTuple):
    """One ply as a part."""

    ply: "StackPly"
    shape: Any
    name: str
    colour: Colour


def parts_of(stack: "PlyStack", solids: bool) -> List[Part]:
    """The plies as faces or as solids, from the tool outwards, coloured by angle."""
    shapes = stack.ply_solids() if solids else [ply.face for ply in stack.plies]
    return [Part(ply, shape, ply.ply.name, angle_colour(ply.ply.ply.angle)) for ply, shape in zip(stack.plies, shapes)]


def assembly_name(stack: "PlyStack") -> str:
    """What the whole is called."""
    count = len(stack.plies)
    return f"Stack of {count} {'ply' if count == 1 else 'plies'}, {stack.report['thickness']:g} mm"
