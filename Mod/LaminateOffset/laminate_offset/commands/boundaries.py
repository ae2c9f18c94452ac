# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arguments of the command line for plies that cover parts of a face."""

import argparse
from typing import Any, Callable, Dict

from ..boundaries import SIDES
from ..boundary_texts import boundaries_of, once, parse_drop_off, parse_side, parse_stagger
from ..stack import RAMP_SLOPES


def add_boundaries(parser: argparse.ArgumentParser) -> None:
    """--boundaries, --side, --drop-off, --ramp-slope, --stagger and --boundary-gap."""
    add = parser.add_argument
    add("--boundaries", metavar="FILE", help="STEP, IGES, BREP or FCStd file with the boundaries that the layup names")
    add(
        "--side",
        action="append",
        default=[],
        type=_told(parse_side),
        metavar="NAME=SIDE",
        help=f"the part that plies keep: {', '.join(SIDES)} (default: inside)",
    )
    add(
        "--drop-off",
        default=20.0,
        type=_told(parse_drop_off),
        metavar="R",
        help="length of a ramp: a multiple of the ply's thickness, or a length such as 5mm (default: %(default)s)",
    )
    add(
        "--ramp-slope",
        choices=RAMP_SLOPES,
        default=RAMP_SLOPES[0],
        help="which slope of a ramp --drop-off stands for (default: %(default)s)",
    )
    add(
        "--stagger",
        action="append",
        default=[],
        type=_told(parse_stagger),
        metavar="NAME=D,D,...",
        help="distances in mm by which successive plies of a boundary keep inside of it",
    )
    add(
        "--boundary-gap",
        type=float,
        metavar="G",
        help="largest distance of a boundary from the face in mm (default: a quarter of its size)",
    )


def boundary_arguments(arguments: argparse.Namespace) -> Dict[str, Any]:
    """What stack_plies takes: boundaries, drop_off, ramp_slope, stagger and boundary_gap. Raises ValueError for a name that
    is not there."""
    return {
        "boundaries": boundaries_of(arguments.boundaries, arguments.side, "--side"),
        "drop_off": arguments.drop_off,
        "ramp_slope": arguments.ramp_slope,
        "stagger": once(arguments.stagger, "--stagger") or None,
        "boundary_gap": arguments.boundary_gap,
    }


def _told(parse: Callable[[str], Any]) -> Callable[[str], Any]:
    """The same for argparse, which passes on the reason of this one exception only."""

    def parsed(text: str) -> Any:
        try:
            return parse(text)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from error

    return parsed
