# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset extend: one face of a file, or every face by itself, past its sides."""

import argparse
from typing import Any, TextIO

from ..api import ExtensionResult, extend_face
from ..each_face import choose, outcome
from ..files import read_faces
from .arguments import REPORT_LIST, add_default_output, add_faces, add_report
from .bar import Bar
from .outputs import check_outputs, default_output, write_outcomes


def add_to(commands: Any) -> None:
    """Describes the command to the parser."""
    parser = commands.add_parser(
        "extend",
        help="extend one face of a file, or every face by itself, past its sides",
        description="Extends one face of a STEP, IGES, BREP or FCStd file, or every face by itself, past its sides.",
        epilog=REPORT_LIST,
    )
    parser.set_defaults(command=run)
    add = parser.add_argument
    add_faces(parser)
    add("--length", required=True, type=float, metavar="L", help="arc length of the extension in mm; above zero")
    add("--sides", default="all", metavar="S", help="all, or some of u-min,u-max,v-min,v-max (default: %(default)s)")
    add(
        "--continuity",
        choices=("G1", "natural"),
        default="G1",
        help="mirror image at the side, or the surface's last piece going on (default: %(default)s)",
    )
    add(
        "--rule",
        choices=("mean", "at-least"),
        default="mean",
        help="what has the length: the mean of eight iso-curves or each of them (default: %(default)s)",
    )
    add_default_output(parser, "extended")
    add_report(parser, "the report")


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    output = arguments.output or default_output(arguments.input, "extended")
    check_outputs(arguments.input, output, arguments.report)

    def extended(face: Any) -> ExtensionResult:
        return extend_face(face, arguments.length, arguments.sides, arguments.continuity, arguments.rule)

    chosen = choose(read_faces(arguments.input), arguments.face, arguments.input)
    outcomes = []
    with Bar(len(chosen), err, "extend") as bar:
        for number, face in chosen:
            outcomes.append(outcome(number, lambda: extended(face)))
            bar.tell(outcomes[-1], out, err)
            bar.show(len(outcomes))
    label = f"Extension {arguments.length:g} mm"
    return write_outcomes(outcomes, arguments.face is not None, output, label, arguments.report, err)
