# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line laminate-offset; each of its commands is a file in `commands`.

Exit codes: 0 done; 1 a face was refused or failed (reasons on stderr and in the report); 2 bad usage, unreadable input
or unwritable output; 130 cancelled with Ctrl-C, nothing written; a batch keeps what is done.
"""

import argparse
import sys
from typing import List, Optional, TextIO

from . import __version__
from .commands import BAD_USAGE, CANCELLED, batch, extend, limits, offset, plies
from .lines import take_over
from .replacing import FileError


def main(argv: Optional[List[str]] = None) -> int:
    """Runs the command line of this process and returns its exit code.

    Only our own lines go to standard output; whether they are read makes no difference to the files that are written.
    """
    arguments = build_parser().parse_args(_glue_negative_numbers(sys.argv[1:] if argv is None else argv))
    out, err = take_over()
    return run(arguments, out, err)


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries out parsed arguments, with results on `out` and reasons on `err`; returns the exit code."""
    try:
        code: int = arguments.command(arguments, out, err)
        return code
    except (FileError, ValueError) as error:
        print(f"laminate-offset: {error}", file=err)
        return BAD_USAGE
    except KeyboardInterrupt:
        print("laminate-offset: cancelled; nothing was written.", file=err)
        return CANCELLED


def build_parser() -> argparse.ArgumentParser:
    """The parser, with its help texts."""
    parser = argparse.ArgumentParser(
        prog="laminate-offset",
        description="Offsets trimmed CAD faces by a constant normal distance, within a tolerance. All lengths in mm.",
        epilog="Exit codes: 0 done; 1 a face was refused or failed; 2 bad usage or unreadable input; 130 cancelled.",
    )
    parser.add_argument("--version", action="version", version=f"laminate-offset {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in (offset, limits, plies, extend, batch):
        command.add_to(commands)
    return parser


def _glue_negative_numbers(argv: List[str]) -> List[str]:
    """Writes "--distance -5e-1" as "--distance=-5e-1": argparse takes a number with an exponent, or several, for an option."""
    glued: List[str] = []
    for text in argv:
        if glued and glued[-1] in ("--distance", "--rosette") and text[:1] == "-" and text[1:2] != "-":
            glued[-1] += "=" + text
        else:
            glued.append(text)
    return glued
