# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repeats table 1 and figures 1 to 9 of Ravi Kumar, Shastry and Prakash (CAD 35, 2003, 411-420) on faces of that kind.

Three trimmed faces of this folder (table1_*.step) have the loops, trimming curves and sizes of the paper's examples;
the paper's own are not published. Each is offset by a tenth of its size to both sides with both methods at 0.1 mm, with
the paper's also on a surface that is extended by the distance. The results are measured by OpenCASCADE's projections
(measure_offset.py), and drawn.

Usage: reproduce_table1.py OUT_FOLDER [--tolerance T] [--grid N] [--edge-points N] [--runs N] [--no-pictures]

Plain python3 needs the add-on's folder on PYTHONPATH. OUT_FOLDER gets table1.csv, table1.md and figure_1.png to
figure_9.png. The exit code is 1 when a deviation exceeds the tolerance.
"""

import argparse
import csv
import os
import sys
import time
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence

HERE = os.path.dirname(os.path.abspath(__file__))
# The add-on is two folders up from where it is installed; inside FreeCAD it is on the path anyway.
sys.path += [HERE, os.path.dirname(os.path.dirname(HERE))]

import measure_offset  # noqa: E402  (finds FreeCAD's modules, too)
import laminate_offset as lo  # noqa: E402
import Part  # noqa: E402

# The routes of the table: the method, and whether the surface is extended by the distance on its four sides.
ROUTES = {
    "same-parameter": ("same-parameter", False),
    "ravi-kumar": ("ravi-kumar", False),
    "ravi-kumar, extended": ("ravi-kumar", True),  # all of the paper's steps
}
DRAWN = "ravi-kumar, extended"
TITLES = {
    "example": "example",
    "loops": "loops",
    "curves": "trimming curves",
    "distance": "d [mm]",
    "route": "route",
    "poles": "poles",
    "degrees": "degrees",
    "time": "shortest CPU time [ms]",
    "certified": "proven error [mm]",
    "surface": "true error [mm]",
    "edge_bound": "proven edge error [mm]",
    "edges": "true edge error [mm]",
}


@dataclass(frozen=True)
class Example:
    """One row of the paper's table."""

    number: int
    stem: str
    distance: float  # mm, a tenth of the diagonal of the face's box
    elevation: float  # degrees, of the eye in the pictures
    azimuth: float

    def face(self) -> Part.Face:
        """The base face."""
        return measure_offset.only_face(os.path.join(HERE, self.stem + ".step"))


EXAMPLES = (
    Example(1, "table1_fairing", 343.0, 24.0, -58.0),
    Example(2, "table1_duct", 227.0, 10.0, -35.0),
    Example(3, "table1_rib", 104.0, 4.0, -50.0),
)


@dataclass(frozen=True)
class Case:
    """One offset with what was reported and measured."""

    example: Example
    base: Part.Face
    distance: float
    route: str
    result: "lo.OffsetResult"
    time: float  # ms
    measured: "measure_offset.Measured"

    def row(self) -> Dict[str, str]:
        """The table's row; lengths in mm, times in ms."""
        report = self.result.report.to_dict()
        surface = report["surface"]
        return {
            "example": str(self.example.number),
            "loops": str(report["loops"]),
            "curves": str(report["edges"]),
            "distance": "%g" % self.distance,
            "route": self.route,
            "poles": "%dx%d" % (surface["poles_u"], surface["poles_v"]) if surface["poles_u"] else surface["type"],
            "degrees": "%d, %d" % (surface["degree_u"], surface["degree_v"]),
            "time": "%.1f" % self.time,
            "certified": shown(report["certified_error"]),
            "surface": shown(max(self.measured.surface_to_base, self.measured.base_to_surface)),
            "edge_bound": shown(report["edge_error"]),
            "edges": shown(max(self.measured.edges_to_base, self.measured.base_to_edges)),
        }


def shown(length: Optional[float]) -> str:
    """A small length for the table."""
    return "none" if length is None else "%.2g" % length


def offset_case(example: Example, distance: float, route: str, options: argparse.Namespace) -> Case:
    """Makes and measures one offset; the time is the shortest of the runs, that of all cores together."""
    base = example.face()
    method, extended = ROUTES[route]
    extension = abs(distance) if extended else 0.0
    times = []
    for _ in range(options.runs):
        started = time.process_time()
        result = lo.offset_face(base, distance, options.tolerance, method, extension)
        times.append(1e3 * (time.process_time() - started))
    measured = measure_offset.measure(base, result.face, distance, options.grid, options.edge_points)
    return Case(example, base, distance, route, result, min(times), measured)


def table(cases: Sequence[Case]) -> str:
    """The table in Markdown."""
    rows = [list(TITLES.values())] + [["---"] * len(TITLES)] + [list(case.row().values()) for case in cases]
    return "\n".join("| %s |" % " | ".join(row) for row in rows) + "\n"


def write_text(path: str, text: str) -> None:
    """Replaces a file in one step."""
    with open(path + ".part", "w", encoding="utf-8", newline="") as stream:
        stream.write(text)
    os.replace(path + ".part", path)


def write_table(folder: str, cases: Sequence[Case]) -> None:
    """table1.md and table1.csv."""
    write_text(os.path.join(folder, "table1.md"), table(cases))
    path = os.path.join(folder, "table1.csv")
    with open(path + ".part", "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, list(TITLES), lineterminator="\n")
        writer.writeheader()
        writer.writerows(case.row() for case in cases)
    os.replace(path + ".part", path)


def draw_first_example(folder: str, plain: Case, extended: Case) -> None:
    """Figures 1 to 6: base, offset and extended offset surface, in space and in parameters."""
    import table1_pictures as pictures

    base, d = plain.base, plain.distance
    offset, wider = plain.result.face.Surface, extended.result.face.Surface
    trimmed = pictures.Layer(base, pictures.BASE, "base face", loops=True)
    under = pictures.Layer(base.Surface.toShape(), pictures.BASE, "underlying surface")
    whole = pictures.Layer(offset.toShape(), pictures.OFFSET, "offset surface at %g mm" % d, lift=0.03)
    around = pictures.Layer(wider.toShape(), pictures.EXTENDED, "extended by %g mm" % abs(d))
    loops = pictures.Layer(extended.result.face, pictures.OFFSET, "inside the offset loops", loops=True, lift=0.03)
    in_space = {
        1: ("A trimmed surface with its loops", [trimmed]),
        3: ("Underlying surface and its offset", [under, whole]),
        4: ("Offset surface, extended", [around, whole]),
        5: ("Extended offset surface with the offset loops", [around, loops]),
    }
    for number, (title, layers) in in_space.items():
        path = os.path.join(folder, "figure_%d.png" % number)
        pictures.draw_in_space(path, "%s (figure %d)" % (title, number), [pictures.View("", layers)])
    pictures.draw_in_parameters(
        os.path.join(folder, "figure_2.png"),
        "The trimmed surface in its parameters [mm] (figure 2)",
        [pictures.Domain(base.Surface.bounds(), "underlying surface")],
        pictures.loops_of(base),
    )
    pictures.draw_in_parameters(
        os.path.join(folder, "figure_6.png"),
        "Offset loops and the extended offset surface in its parameters [mm] (figure 6)",
        [
            pictures.Domain(wider.bounds(), "extended offset surface"),
            pictures.Domain(offset.bounds(), "offset surface", "--"),
        ],
        pictures.loops_of(extended.result.face),
    )


def draw_both_sides(folder: str, example: Example, cases: Sequence[Case]) -> None:
    """Figures 7 to 9: base and offset face, to both sides."""
    import table1_pictures as pictures

    views = []
    for case in cases:
        layers = [
            pictures.Layer(case.base, pictures.BASE, "base face"),
            pictures.Layer(case.result.face, pictures.OFFSET, "offset face"),
        ]
        views.append(pictures.View("d = %g mm" % case.distance, layers, example.elevation, example.azimuth))
    number = 6 + example.number
    title = "Base and offset trimmed surface of example %d (figure %d)" % (example.number, number)
    pictures.draw_in_space(os.path.join(folder, "figure_%d.png" % number), title, views)


def draw(folder: str, cases: Sequence[Case]) -> None:
    """All figures, from the results of the paper's method."""
    first = {case.route: case for case in reversed(cases) if case.example == EXAMPLES[0]}
    draw_first_example(folder, first["ravi-kumar"], first[DRAWN])
    for example in EXAMPLES:
        sides = [case for case in cases if case.example == example and case.route == DRAWN]
        draw_both_sides(folder, example, sides)


def main(arguments: Sequence[str]) -> int:
    """Runs the command; returns its exit code."""
    parser = argparse.ArgumentParser(description="Table 1 and the figures of Ravi Kumar, Shastry and Prakash (2003).")
    parser.add_argument("folder")
    parser.add_argument("--tolerance", type=float, default=0.1, help="largest deviation [mm]")
    parser.add_argument("--grid", type=int, default=40, help="measured points in each direction of a surface")
    parser.add_argument("--edge-points", type=int, default=60, help="measured points along each edge")
    parser.add_argument("--runs", type=int, default=3, help="repetitions; the shortest time counts")
    parser.add_argument("--no-pictures", action="store_true")
    options = parser.parse_args(arguments)
    os.makedirs(options.folder, exist_ok=True)
    cases: List[Case] = [
        offset_case(example, sign * example.distance, route, options)
        for example in EXAMPLES
        for route in ROUTES
        for sign in (1.0, -1.0)
    ]
    write_table(options.folder, cases)
    print(table(cases), end="")
    if not options.no_pictures:
        draw(options.folder, cases)
    worst = max(case.measured.worst for case in cases)
    met = worst <= options.tolerance
    print(
        "largest deviation measured: %.3g mm, %s %g mm" % (worst, "within" if met else "NOT within", options.tolerance)
    )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
