# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arguments that several commands share."""

import argparse
from typing import Optional

from .. import _core

INPUT_HELP = "STEP, IGES, BREP or FCStd file (there, the faces of its visible Part features)"
OUTPUT_HELP = ".step, .iges, .brep or .FCStd file"
REPORT_LIST = (
    "With --face all the output is one compound of the faces that succeeded, in their order, and the report is a list "
    "with every face."
)


def add_input(parser: argparse.ArgumentParser) -> None:
    """INPUT."""
    parser.add_argument("input", metavar="INPUT", help=INPUT_HELP)


def add_faces(parser: argparse.ArgumentParser) -> None:
    """INPUT and --face, a number or all (None)."""
    add_input(parser)
    help_text = "face number from 1, or all"
    parser.add_argument("--face", required=True, type=face_number, metavar="N|all", help=help_text)


def add_tolerance(parser: argparse.ArgumentParser) -> None:
    """--tolerance."""
    default = _core.default_options()["tolerance"]
    parser.add_argument("--tolerance", type=float, default=default, metavar="T", help="in mm (default: %(default)s)")


def add_default_output(parser: argparse.ArgumentParser, what: str) -> None:
    """-o, which default_output names when it is left out."""
    name = f"default: the input's name with _{what}.step, in this folder"
    parser.add_argument("-o", "--output", metavar="OUT", help=f"{OUTPUT_HELP} ({name})")


def add_report(parser: argparse.ArgumentParser, what: str) -> None:
    """--report."""
    parser.add_argument("--report", metavar="R.json", help=f"write {what} as JSON")


def face_number(text: str) -> Optional[int]:
    """A face number, or None for all."""
    if text == "all":
        return None
    try:
        number = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is neither a face number nor all") from None
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number}: faces count from 1")
    return number


def one_face_number(text: str) -> int:
    """A face number; a stack needs one face."""
    number = face_number(text)
    if number is None:
        raise argparse.ArgumentTypeError("a stack lies on one face; give its number")
    return number
