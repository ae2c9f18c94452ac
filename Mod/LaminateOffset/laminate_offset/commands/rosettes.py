# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arguments of the command line for the axes that ply angles refer to."""

import argparse
from typing import Dict, Optional, Tuple

from ..layup import Layup
from ..rosette import Rosette, Rosettes

FORM = "[NAME=]X,Y,Z:DX,DY,DZ"


def add_rosettes(parser: argparse.ArgumentParser) -> None:
    """--rosette."""
    parser.add_argument(
        "--rosette",
        action="append",
        default=[],
        type=_parsed,
        metavar=FORM,
        help="origin and first axis of a rosette, for --book, --calculix and --hdf5; NAME as rows of the layup have it, and none "
        "for those that name no rosette (default: the model's x axis, or another one where x stands on the face)",
    )


def rosettes_of(arguments: argparse.Namespace, layup: Layup) -> Optional[Rosettes]:
    """All rosettes that were given, by name, or None. Raises ValueError for a name that no row has, for one that stands twice,
    for rows without a rosette among those given, and where no file that is asked for needs one."""
    if not arguments.rosette:
        return None
    if all(path is None for path in (arguments.book, arguments.calculix, arguments.hdf5)):
        raise ValueError(
            "--rosette: no file that is asked for has angles from a rosette; give --book, --calculix or --hdf5, too, or leave it "
            "out."
        )
    known = [ply.ply.rosette for ply in layup.physical_plies()]
    axes: Dict[str, Rosette] = {}
    for name, rosette in arguments.rosette:
        if name not in known:
            named = ", ".join(sorted({repr(other) if other else "none" for other in known}))
            raise ValueError(f"--rosette: no row of the layup names {name!r}; the rows name {named}.")
        if name in axes:
            raise ValueError(f"--rosette: {name or FORM} is given twice.")
        axes[name] = rosette
    for name in known:
        if name not in axes:
            rows = f"the rows that name {name!r}" if name else "rows that name no rosette"
            raise ValueError(f"--rosette: there is none for {rows}; give all of them.")
    return axes


def _parsed(text: str) -> Tuple[str, Rosette]:
    name, equals, numbers = text.rpartition("=")
    if equals and not name:
        raise argparse.ArgumentTypeError(f"{text}: a name must stand before =; write {FORM}.")
    parts = numbers.split(":")
    if len(parts) != 2:
        raise argparse.ArgumentTypeError(
            f"{text}: origin and first axis must stand on either side of one colon; write {FORM}."
        )
    origin, direction = (_three(part, text) for part in parts)
    try:
        return name, Rosette(origin, direction)
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text}: write {FORM}: {error}") from error


def _three(part: str, text: str) -> Tuple[float, float, float]:
    try:
        x, y, z = (float(number) for number in part.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text}: '{part}' is not three numbers with commas between; write {FORM}, with lengths in mm."
        ) from None
    return x, y, z
