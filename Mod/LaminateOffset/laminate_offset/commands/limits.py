# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset limits: how far faces can be offset."""

import argparse
from typing import Any, Dict, List, TextIO

from ..api import offset_limits
from ..each_face import choose, kernel_error, refusal_line
from ..errors import OffsetError
from ..files import read_faces, write_json
from . import DONE, REFUSED
from .arguments import add_faces, add_report
from .outputs import check_results


def add_to(commands: Any) -> None:
    """Describes the command to the parser."""
    parser = commands.add_parser(
        "limits",
        help="print how far one face of a file, or every face, can be offset",
        description="Prints the feasible distances of one face of a STEP, IGES, BREP or FCStd file, or of every face, in "
        "mm along its outward normal: beyond them the offset would fold.",
        epilog="With --face all the report is a list with every face.",
    )
    parser.set_defaults(command=run)
    add_faces(parser)
    add_report(parser, "the limits and their places")


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    check_results([arguments.input], [arguments.report])
    chosen = choose(read_faces(arguments.input), arguments.face, arguments.input)
    reports: List[Dict[str, Any]] = [{"face": number, **_limits_of(number, face, out, err)} for number, face in chosen]
    if arguments.report:
        write_json(reports[0] if arguments.face is not None else reports, arguments.report)
    return DONE if all(report["status"] == "ok" for report in reports) else REFUSED


def _limits_of(number: int, face: Any, out: TextIO, err: TextIO) -> Dict[str, Any]:
    """One face's limits in their documented form, which holds for refusals too."""
    try:
        limits = offset_limits(face)
    except (OffsetError, RuntimeError, MemoryError) as error:
        refusal = error if isinstance(error, OffsetError) else kernel_error(error)
        print(f"laminate-offset: {refusal_line(number, refusal)}", file=err)
        reason = {name: getattr(refusal, name) for name in ("status", "stage", "message", "where")}
        return {**reason, "proven": None, "negative": None, "positive": None}
    print(f"face {number}: {limits.summary()}", file=out)
    return limits.to_dict()
