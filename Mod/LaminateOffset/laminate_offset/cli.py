# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line laminate-offset.

Exit codes: 0 done; 1 a face was refused or failed (reasons on stderr and in the report); 2 bad usage, unreadable input
or unwritable output; 130 cancelled with Ctrl-C, nothing written.
"""

import argparse
import os
import sys
from typing import Any, Dict, List, Optional, TextIO, Tuple

import Part

from . import __version__, _core
from .api import OffsetResult, Progress, extend_face, offset_face, offset_limits
from .errors import OffsetError
from .files import check_writable, format_of, read_faces, write_json, write_shape
from .lines import take_over
from .layup import read_layup
from .replacing import FileError
from .stack import SURFACES, stack_plies

DONE, REFUSED, BAD_USAGE, CANCELLED = 0, 1, 2, 130


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
    _add_offset_command(commands)
    _add_limits_command(commands)
    _add_plies_command(commands)
    _add_extend_command(commands)
    return parser


def _add_input(parser: argparse.ArgumentParser) -> None:
    source = "STEP, IGES, BREP or FCStd file (there, the faces of its visible Part features)"
    parser.add_argument("input", metavar="INPUT", help=source)


def _add_faces(parser: argparse.ArgumentParser) -> None:
    _add_input(parser)
    help_text = "face number from 1, or all"
    parser.add_argument("--face", required=True, type=_face_number, metavar="N|all", help=help_text)


def _add_offset_command(commands: Any) -> None:
    defaults = _core.default_options()
    parser = commands.add_parser(
        "offset",
        help="offset one face of a file, or every face by itself",
        description="Offsets one face of a STEP, IGES, BREP or FCStd file, or every face by itself.",
        epilog="With --face all the output is one compound of the faces that succeeded, in their order, and the "
        "report is a list with every face.",
    )
    parser.set_defaults(command=_offset)
    add = parser.add_argument
    _add_faces(parser)
    add(
        "--distance",
        required=True,
        type=float,
        metavar="D",
        help="signed distance in mm along the face's outward normal; negative goes inwards",
    )
    add("--tolerance", type=float, default=defaults["tolerance"], metavar="T", help="in mm (default: %(default)s)")
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
        help="length in mm to extend the result past the edges (default: %(default)s)",
    )
    add(
        "--max-degree",
        type=int,
        default=defaults["max_degree"],
        metavar="P",
        help="highest degree of the surface (default: %(default)s)",
    )
    add(
        "-o",
        "--output",
        metavar="OUT",
        help=".step, .iges, .brep or .FCStd file (default: the input's name with _offset.step, in this folder)",
    )
    add("--report", metavar="R.json", help="write the report as JSON")


def _add_limits_command(commands: Any) -> None:
    parser = commands.add_parser(
        "limits",
        help="print how far one face of a file, or every face, can be offset",
        description="Prints the feasible distances of one face of a STEP, IGES, BREP or FCStd file, or of every face, in "
        "mm along its outward normal: beyond them the offset would fold.",
        epilog="With --face all the report is a list with every face.",
    )
    parser.set_defaults(command=_limits)
    add = parser.add_argument
    _add_faces(parser)
    add("--report", metavar="R.json", help="write the limits and their places as JSON")


def _add_plies_command(commands: Any) -> None:
    parser = commands.add_parser(
        "plies",
        help="lay the plies of a layup on one face of a file",
        description="Lays the plies of a layup table on one face of a STEP, IGES, BREP or FCStd file and writes one "
        "face for each ply, from the tool outwards. All of them come from one fit.",
    )
    parser.set_defaults(command=_plies)
    add = parser.add_argument
    _add_input(parser)
    add("--face", required=True, type=_one_face_number, metavar="N", help="face number from 1")
    add("--layup", required=True, metavar="LAYUP", help="layup table (.csv) or document (.json, .yaml)")
    add(
        "--tolerance",
        type=float,
        default=_core.default_options()["tolerance"],
        metavar="T",
        help="in mm (default: %(default)s)",
    )
    add("--direction", choices=("normal", "reversed"), help="side of the face to stack on (default: the layup's own)")
    add("--surface", choices=SURFACES, default="top", help="surface of each ply to write (default: %(default)s)")
    add("-o", "--output", required=True, metavar="OUT", help=".step, .iges, .brep or .FCStd file")
    add("--report", metavar="R.json", help="write the stack's report as JSON, with one entry for every ply")


def _one_face_number(text: str) -> int:
    """A face number; a stack needs one face."""
    number = _face_number(text)
    if number is None:
        raise argparse.ArgumentTypeError("a stack lies on one face; give its number")
    return number


def _add_extend_command(commands: Any) -> None:
    parser = commands.add_parser(
        "extend",
        help="extend one face of a file, or every face by itself, past its sides",
        description="Extends one face of a STEP, IGES, BREP or FCStd file, or every face by itself, past its sides.",
        epilog="With --face all the output is one compound of the faces that succeeded, in their order, and the "
        "report is a list with every face.",
    )
    parser.set_defaults(command=_extend)
    add = parser.add_argument
    _add_faces(parser)
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
    add(
        "-o",
        "--output",
        metavar="OUT",
        help=".step, .iges, .brep or .FCStd file (default: the input's name with _extended.step, in this folder)",
    )
    add("--report", metavar="R.json", help="write the report as JSON")


def _face_number(text: str) -> Optional[int]:
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


def _glue_negative_numbers(argv: List[str]) -> List[str]:
    """Writes "--distance -5e-1" as "--distance=-5e-1": argparse takes a number with an exponent for an option."""
    glued: List[str] = []
    for text in argv:
        if glued and glued[-1] == "--distance" and text.startswith("-"):
            glued[-1] += "=" + text
        else:
            glued.append(text)
    return glued


def _offset(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    output = arguments.output or _default_output(arguments.input, "offset")
    _check_outputs(arguments.input, output, arguments.report)
    chosen = _choose(read_faces(arguments.input), arguments.face, arguments.input)
    faces, reports = _offset_each(chosen, arguments, out, err)
    if faces:
        shape = faces[0] if arguments.face is not None else Part.makeCompound(faces)
        write_shape(shape, output, f"Offset {arguments.distance:g} mm")
        print(f"laminate-offset: wrote {output}", file=err)
    if arguments.report:
        write_json(reports[0] if arguments.face is not None else reports, arguments.report)
    return DONE if len(faces) == len(chosen) else REFUSED


def _extend(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    output = arguments.output or _default_output(arguments.input, "extended")
    _check_outputs(arguments.input, output, arguments.report)
    chosen = _choose(read_faces(arguments.input), arguments.face, arguments.input)
    faces: List["Part.Face"] = []
    reports: List[Dict[str, Any]] = []
    for number, face in chosen:
        try:
            result = extend_face(face, arguments.length, arguments.sides, arguments.continuity, arguments.rule)
        except (OffsetError, RuntimeError, MemoryError) as error:
            refusal = error if isinstance(error, OffsetError) else _kernel_error(error)
            print(f"laminate-offset: face {number} refused at {refusal.stage}: {refusal}", file=err)
            reports.append({"face": number, **refusal.report.to_dict()})
        else:
            faces.append(result.face)
            print(f"face {number}: {result.report.summary()}", file=out)
            reports.append({"face": number, **result.report.to_dict()})
    if faces:
        shape = faces[0] if arguments.face is not None else Part.makeCompound(faces)
        write_shape(shape, output, f"Extension {arguments.length:g} mm")
        print(f"laminate-offset: wrote {output}", file=err)
    if arguments.report:
        write_json(reports[0] if arguments.face is not None else reports, arguments.report)
    return DONE if len(faces) == len(chosen) else REFUSED


def _kernel_error(error: BaseException) -> OffsetError:
    return OffsetError("kernel-error", "input", f"The face could not be processed: {error}")


def _limits(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    if arguments.report:
        _check_report(arguments.input, arguments.report)
    reports: List[Dict[str, Any]] = []
    for number, face in _choose(read_faces(arguments.input), arguments.face, arguments.input):
        values = _limits_of(number, face, out, err)
        reports.append({"face": number, **values})
    if arguments.report:
        write_json(reports[0] if arguments.face is not None else reports, arguments.report)
    return DONE if all(report["status"] == "ok" for report in reports) else REFUSED


def _plies(arguments: argparse.Namespace, out: TextIO, err: TextIO) -> int:
    _check_outputs(arguments.input, arguments.output, arguments.report)
    layup = read_layup(arguments.layup)
    ((_, face),) = _choose(read_faces(arguments.input), arguments.face, arguments.input)
    try:
        with _Bar(1, err) as bar:
            stack = stack_plies(
                face,
                layup,
                arguments.tolerance,
                arguments.direction,
                arguments.surface,
                progress=bar.progress_after(0),
            )
    except OffsetError as refusal:
        print(f"laminate-offset: face {arguments.face} refused at {refusal.stage}: {refusal}", file=err)
        if arguments.report:
            write_json(refusal.report.to_dict(), arguments.report)
        return REFUSED
    write_shape(stack.to_shape(), arguments.output, f"{len(stack.plies)} plies")
    print(f"laminate-offset: wrote {arguments.output}", file=err)
    print(f"face {arguments.face}: {stack.summary()}", file=out)
    if arguments.report:
        write_json({**stack.report, "stack": stack.ply_reports()}, arguments.report)
    return DONE


def _limits_of(number: int, face: "Part.Face", out: TextIO, err: TextIO) -> Dict[str, Any]:
    """One face's limits in their documented form, which holds for refusals too."""
    try:
        limits = offset_limits(face)
    except OffsetError as refusal:
        print(f"laminate-offset: face {number} refused at {refusal.stage}: {refusal}", file=err)
        reason = {name: getattr(refusal, name) for name in ("status", "stage", "message", "where")}
    except (RuntimeError, MemoryError) as error:
        message = f"The face could not be processed: {error}"
        print(f"laminate-offset: face {number} failed: {message}", file=err)
        reason = {"status": "kernel-error", "stage": "input", "message": message, "where": None}
    else:
        print(f"face {number}: {limits.summary()}", file=out)
        return limits.to_dict()
    return {**reason, "proven": None, "negative": None, "positive": None}


def _check_report(source: str, report: str) -> None:
    if _is_same_file(report, source):
        raise FileError(f"{report}: is the input; name another file for the report.")
    check_writable(report)


def _default_output(source: str, what: str) -> str:
    return os.path.splitext(os.path.basename(source))[0] + f"_{what}.step"


def _check_outputs(source: str, output: str, report: Optional[str]) -> None:
    """Finds out before the work whether its results can be kept, and that they replace neither input nor each other."""
    format_of(output)
    for path in (output, report):
        if path is None:
            continue
        if _is_same_file(path, source):
            raise FileError(f"{path}: is the input; name another file for the result.")
        check_writable(path)
    if report is not None and _is_same_file(report, output):
        raise FileError(f"{report}: is also the output; give the report a name of its own.")


def _is_same_file(first: str, second: str) -> bool:
    if os.path.exists(first) and os.path.exists(second):
        return os.path.samefile(first, second)
    return os.path.realpath(first) == os.path.realpath(second)


def _choose(faces: List["Part.Face"], number: Optional[int], source: str) -> List[Tuple[int, "Part.Face"]]:
    """The numbered faces to offset."""
    numbered = list(enumerate(faces, start=1))
    if number is None:
        return numbered
    if number > len(faces):
        raise FileError(f"{source}: there is no face {number}; it has {len(faces)}.")
    return [numbered[number - 1]]


def _offset_each(
    chosen: List[Tuple[int, "Part.Face"]], arguments: argparse.Namespace, out: TextIO, err: TextIO
) -> Tuple[List["Part.Face"], List[Dict[str, Any]]]:
    """The new faces, and the reports of all; a refusal does not stop the others."""
    faces: List["Part.Face"] = []
    reports: List[Dict[str, Any]] = []
    with _Bar(len(chosen), err) as bar:
        for done, (number, face) in enumerate(chosen):
            try:
                result = _offset_one(face, arguments, bar.progress_after(done))
                faces.append(result.shape)
                report = result.report
                bar.write(f"face {number}: {report.summary()}", out)
            except OffsetError as refusal:
                report = refusal.report
                bar.write(f"laminate-offset: face {number} refused at {refusal.stage}: {refusal}", err)
            reports.append({"face": number, **report.to_dict()})
    return faces, reports


def _offset_one(face: "Part.Face", arguments: argparse.Namespace, progress: Progress) -> OffsetResult:
    try:
        return offset_face(
            face,
            arguments.distance,
            arguments.tolerance,
            arguments.method,
            arguments.extension,
            arguments.max_degree,
            progress,
        )
    except OffsetError:
        raise
    except (RuntimeError, MemoryError) as error:
        raise _kernel_error(error) from error


class _Bar:
    """A progress bar on a terminal, where tqdm is installed; otherwise nothing is drawn."""

    def __init__(self, faces: int, stream: TextIO) -> None:
        self._bar: Any = None
        if stream.isatty():
            try:
                from tqdm import tqdm
            except ImportError:
                return
            form = "{l_bar}{bar}| {elapsed}<{remaining}"
            self._bar = tqdm(total=float(faces), file=stream, leave=False, desc="offset", bar_format=form)

    def __enter__(self) -> "_Bar":
        return self

    def __exit__(self, *_exception: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def progress_after(self, done: int) -> Progress:
        """The callback for the face that follows `done` finished ones."""

        def show(fraction: float) -> None:
            if self._bar is not None:
                self._bar.n = done + fraction
                self._bar.refresh()

        return show

    def write(self, line: str, stream: TextIO) -> None:
        """Prints a line without tearing the bar."""
        if self._bar is not None:
            self._bar.clear()
        print(line, file=stream, flush=True)
