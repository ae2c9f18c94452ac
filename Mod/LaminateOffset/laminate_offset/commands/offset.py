# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset offset: one face of a file, or every face by itself."""

import argparse
from typing import Any, TextIO

from .. import _core
from ..each_face import OffsetRequest, choose, offset_each
from ..files import read_faces
from .arguments import REPORT_LIST, add_default_output, add_faces, add_report, add_tolerance
from .bar import Bar
from .outputs import check_outputs, default_output, write_outcomes


def add_to(commands: Any) -> None:
    """Describes the command to the parser."""
    defaults = _core.default_options()
    parser = commands.add_parser(
        "offset",
        help="offset one face of a file, or every face by itself",
        description="Offsets one face of a STEP, IGES, BREP or FCStd file, or every face by itself.",
        epilog=REPORT_LIST,
    )
    parser.set_defaults(command=run)
    add = parser.add_argument
    add_faces(parser)
    add(
        "--distance",
        required=True,
        type=float,
        metavar="D",
        help="signed distance in mm along the face's outward normal; negative goes inwards",
    )
    add_tolerance(parser)
    add(
        "--method",
        choices=("same-parameter", "ravi-kumar"),
        default=defaults["method"],
        help="route to the offset (default: %(default)s)",
    )
    add(
        "--extension",
        type=float,
        default=defaults["extension"],
        metavar="E",
        help="length in mm to extend the result past its four sides; ravi-kumar extends the surface, not its loops "
        "(default: %(default)s)",
    )
    add(
        "--max-degree",
        type=int,
        default=defaults["max_degree"],
        metavar="P",
        help="highest degree of the surface (default: %(default)s)",
    )
    add_default_output(parser, "offset")
    add_report(parser, "the report")


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    output = arguments.output or default_output(arguments.input, "offset")
    check_outputs(arguments.input, output, arguments.report)
    request = OffsetRequest(
        arguments.distance, arguments.tolerance, arguments.method, arguments.extension, arguments.max_degree
    )
    chosen = choose(read_faces(arguments.input), arguments.face, arguments.input)
    outcomes = []
    with Bar(len(chosen), err) as bar:
        for outcome in offset_each(chosen, request, bar.show):
            bar.tell(outcome, out, err)
            outcomes.append(outcome)
    label = f"Offset {arguments.distance:g} mm"
    return write_outcomes(outcomes, arguments.face is not None, output, label, arguments.report, err)
