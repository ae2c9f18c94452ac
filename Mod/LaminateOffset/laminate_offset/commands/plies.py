# SPDX-License-Identifier: LGPL-2.1-or-later
"""laminate-offset plies: the plies of a layup on one face of a file."""

import argparse
import os
from contextlib import ExitStack, contextmanager
from typing import Any, Dict, Iterator, List, Optional, TextIO

from ..each_face import choose, refusal_line
from ..errors import OffsetError
from ..export import export_calculix, export_composite_cae, export_ply_book
from ..export.calculix import check_section
from ..export.composite_cae import check_creases, check_rosettes, require_h5py
from ..export.fibres import ONE_ROSETTE
from ..export.pictures import require_matplotlib
from ..export.step import SCHEMAS
from ..files import format_of, read_faces, write_json
from ..layup import Layup, read_layup
from ..replacing import FileError, replacing
from ..rosette import Rosette, Rosettes, check_none_named, check_one_rosette, rosette_of
from ..stack import SURFACES, PlyStack, stack_plies
from . import DONE, REFUSED
from .arguments import OUTPUT_HELP, add_input, add_report, add_tolerance, one_face_number
from .bar import Bar
from .boundaries import add_boundaries, boundary_arguments
from .outputs import check_results
from .rosettes import add_rosettes, rosettes_of

# Options that write something else than shapes, and the endings that its file may have.
TEXTS = {"book": (".html",), "table": (".csv",), "calculix": (".inp",), "hdf5": (".h5", ".hdf5")}


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
    add_boundaries(parser)
    add("-o", "--output", required=True, metavar="OUT", help=f"{OUTPUT_HELP}; STEP and FCStd hold names and colours")
    add("--schema", choices=SCHEMAS, default=SCHEMAS[0], help="of a STEP file (default: %(default)s)")
    add("--book", metavar="BOOK.html", help="write the ply book: figures and a picture of every ply")
    add("--table", metavar="PLIES.csv", help="write the table of the plies")
    add("--calculix", metavar="FILE.inp", help="write the section of a shell for CalculiX")
    add("--hdf5", metavar="FILE.h5", help="write the layup on meshes, in the layout HDF5 composite CAE")
    add_rosettes(parser)
    add_report(parser, "the stack's report, with one entry for every ply,")


def run(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    """Carries the command out."""
    _check_arguments(arguments)
    layup = read_layup(arguments.layup)
    axes = rosettes_of(arguments, layup)
    _check_layup(arguments, layup, axes)
    bounded = boundary_arguments(arguments)
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
                **bounded,
            )
    except OffsetError as refusal:
        print(f"laminate-offset: {refusal_line(number, refusal)}", file=err)
        if arguments.report:
            write_json(refusal.report.to_dict(), arguments.report)
        return REFUSED
    try:
        written = _write(stack, arguments, axes, err)
    except (FileError, ValueError) as error:
        if arguments.report:
            write_json(_unwritten(stack, error), arguments.report)
        raise
    for path in written:
        print(f"laminate-offset: wrote {path}", file=err)
    for warning in stack.report["warnings"]:
        print(f"laminate-offset: warning: {warning}", file=err)
    print(f"face {number}: {stack.summary()}", file=out)
    if arguments.report:
        write_json({**stack.report, "stack": stack.ply_reports()}, arguments.report)
    return DONE


def _check_arguments(arguments: argparse.Namespace) -> None:
    """Finds out before the work whether its results can be kept."""
    format_of(arguments.output)
    for option, endings in TEXTS.items():
        path = getattr(arguments, option)
        if path is not None and os.path.splitext(path)[1].lower() not in endings:
            raise FileError(f"--{option}: {path}: the name must end in {' or '.join(endings)}.")
    if arguments.book is not None:
        require_matplotlib()
    if arguments.hdf5 is not None:
        require_h5py()
    texts = [getattr(arguments, option) for option in TEXTS]
    sources = [arguments.input, arguments.layup] + ([arguments.boundaries] if arguments.boundaries else [])
    check_results(sources, [arguments.output, arguments.report, *texts])


def _check_layup(arguments: argparse.Namespace, layup: Layup, axes: Optional[Rosettes]) -> None:
    """Finds out before the work whether the texts that are asked for can hold the layup."""
    plies = layup.physical_plies()
    if arguments.calculix is not None:
        check_section(plies)
    if arguments.book is not None:
        check_one_rosette(plies, ONE_ROSETTE)
    if axes is None and (arguments.book is not None or arguments.calculix is not None):
        check_none_named(plies, "with --rosette")
    if arguments.hdf5 is not None:
        check_rosettes(plies, axes, "with --rosette")


def _unwritten(stack: PlyStack, error: Exception) -> Dict[str, Any]:
    """The report on a stack of which nothing was written."""
    return {
        **stack.report,
        "status": "not-written",
        "stage": "export",
        "message": str(error),
        "stack": stack.ply_reports(),
    }


def _write(stack: PlyStack, arguments: argparse.Namespace, axes: Optional[Rosettes], err: TextIO) -> List[str]:
    """Writes all files that were asked for, or none of them; returns their paths."""
    if arguments.hdf5 is not None:
        check_creases(stack)
    plies = [ply.ply for ply in stack.plies]
    one = None if axes is None else rosette_of(axes, plies[0].ply.rosette, plies)  # for what holds plies of one only
    texts = {option: getattr(arguments, option) for option in TEXTS if getattr(arguments, option) is not None}
    with ExitStack() as files:  # the files take their places together, at its end
        with _made(files, arguments.output) as path:
            stack.export(path, arguments.solids, arguments.schema)
        for option, target in texts.items():
            with _made(files, target) as path:
                _write_text(option, stack, path, one, axes, err)
    return [arguments.output, *texts.values()]


@contextmanager
def _made(files: ExitStack, target: str) -> Iterator[str]:
    """A path to write to now, which becomes the target when `files` ends without an exception."""
    path = files.enter_context(replacing(target))
    try:
        yield path
    except FileError as error:
        raise FileError(str(error).replace(path, target)) from error


def _write_text(
    option: str, stack: PlyStack, path: str, one: Optional[Rosette], axes: Optional[Rosettes], err: TextIO
) -> None:
    """Writes the file of one of TEXTS."""
    if option == "book":
        with Bar(1, err, "ply book") as bar:
            export_ply_book(stack, path, rosette=one, progress=bar.progress_after(0))
    elif option == "calculix":
        export_calculix(stack, path, rosette=one)
    elif option == "hdf5":
        export_composite_cae(stack, path, rosette=axes)
    else:
        stack.export(path)
