# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset plies: the plies of a layup on one face of a file."""

import argparse
from typing import Any, TextIO

from ..each_face import choose, refusal_line
from ..errors import OffsetError
from ..files import read_faces, write_json, write_shape
from ..layup import read_layup
from ..stack import SURFACES, stack_plies
from . import DONE, REFUSED
from .arguments import OUTPUT_HELP, add_input, add_report, add_tolerance, one_face_number
from .bar import Bar
from .outputs import check_outputs


def add_to(commands: Any) -> None:
    """Describes the command to the parser."""
    parser = commands.add_parser(
        "plies",
        help="lay the plies of a layup on one face of a file",
        description="Lays the plies of a layup table on one face of a STEP, IGES, BREP or FCStd file and writes one "
        "face or solid for each ply, from the tool outwards. All of them come from one fit.",
    )
    parser.set_defaults(command=run)
    add = parser.add_argument
    add_input(parser)
    add("--face", required=True, type=one_face_number, metavar="N", help="face number from 1")
    add("--layup", required=True, metavar="LAYUP", help="layup table (.csv) or document (.json, .yaml)")
    add_tolerance(parser)
    add("--direction", choices=("normal", "reversed"), help="side of the face to stack on (default: the layup's own)")
    add("--surface", choices=SURFACES, default="top", help="surface of each ply to write (default: %(default)s)")
    add("--solids", action="store_true", help="write every ply as a solid instead of a face")
    add("-o", "--output", required=True, metavar="OUT", help=OUTPUT_HELP)
    add_report(parser, "the stack's report, with one entry for every ply,")


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    check_outputs(arguments.input, arguments.output, arguments.report)
    layup = read_layup(arguments.layup)
    ((number, face),) = choose(read_faces(arguments.input), arguments.face, arguments.input)
    try:
        with Bar(1, err, "plies") as bar:
            stack = stack_plies(
                face,
                layup,
                arguments.tolerance,
                arguments.direction,
                arguments.surface,
                progress=bar.progress_after(0),
                solids=arguments.solids,
            )
    except OffsetError as refusal:
        print(f"laminate-offset: {refusal_line(number, refusal)}", file=err)
        if arguments.report:
            write_json(refusal.report.to_dict(), arguments.report)
        return REFUSED
    write_shape(stack.to_shape(arguments.solids), arguments.output, f"{len(stack.plies)} plies")
    print(f"laminate-offset: wrote {arguments.output}", file=err)
    print(f"face {number}: {stack.summary()}", file=out)
    if arguments.report:
        write_json({**stack.report, "stack": stack.ply_reports()}, arguments.report)
    return DONE
