# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arguments of the command line for plies that cover parts of a face."""

import argparse
from typing import Any, Dict, List, Tuple

import FreeCAD

from ..boundaries import SIDES, Boundary
from ..files import read_named_shapes


def add_boundaries(parser: argparse.ArgumentParser) -> None:
    """--boundaries, --side, --drop-off and --stagger."""
    add = parser.add_argument
    add("--boundaries", metavar="FILE", help="STEP, IGES, BREP or FCStd file with the boundaries that the layup names")
    add(
        "--side",
        action="append",
        default=[],
        type=_side,
        metavar="NAME=SIDE",
        help=f"the part that plies keep: {', '.join(SIDES)} (default: inside)",
    )
    add(
        "--drop-off",
        default=20.0,
        type=_drop_off,
        metavar="R",
        help="length of a ramp: a multiple of the ply's thickness, or a length such as 5mm (default: %(default)s)",
    )
    add(
        "--stagger",
        action="append",
        default=[],
        type=_stagger,
        metavar="NAME=D,D,...",
        help="distances in mm by which successive plies of a boundary keep inside of it",
    )


def boundary_arguments(arguments: argparse.Namespace) -> Dict[str, Any]:
    """boundaries, drop_off and stagger as stack_plies takes them. Raises ValueError for a name that is not there."""
    shapes = read_named_shapes(arguments.boundaries) if arguments.boundaries else {}
    sides = dict(arguments.side)
    for name in sides:
        if name not in shapes:
            raise ValueError(f"--side: there is no boundary {name!r}; {_known(list(shapes))}.")
    boundaries = {name: Boundary(shape, sides.get(name, SIDES[0])) for name, shape in shapes.items()}
    return {"boundaries": boundaries, "drop_off": arguments.drop_off, "stagger": dict(arguments.stagger) or None}


def _known(names: List[str]) -> str:
    return f"use one of {', '.join(names)}" if names else "give a file of boundaries with --boundaries"


def _named(text: str, what: str) -> Tuple[str, str]:
    name, equals, value = text.rpartition("=")
    if not (name and equals and value):
        raise argparse.ArgumentTypeError(f"'{text}' is not of the form NAME={what}")
    return name, value


def _side(text: str) -> Tuple[str, str]:
    name, side = _named(text, "SIDE")
    if side not in SIDES:
        raise argparse.ArgumentTypeError(f"'{side}' is none of {', '.join(SIDES)}")
    return name, side


def _stagger(text: str) -> Tuple[str, List[float]]:
    name, values = _named(text, "D,D,...")
    try:
        return name, [float(value) for value in values.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{values}' is no list of distances in mm") from None


def _drop_off(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        pass
    try:
        length = FreeCAD.Units.Quantity(text)
    except (OSError, ValueError, ArithmeticError):
        length = None
    if length is None or length.Unit != FreeCAD.Units.Length:
        raise argparse.ArgumentTypeError(f"'{text}' is neither a number nor a length such as 5mm")
    return length
