# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ply book: one HTML file with a cover, the table of plies, and a page with figures and a picture for every ply."""

import base64
import os
from html import escape
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Tuple

from .. import _core
from ..layup import LayupError
from ..mass_properties import PlyProperties
from ..messages import number, surface_type
from ..ply_colours import Colour, angle_colour
from ..replacing import replacing
from ..rosette import Rosette
from .pictures import ply_picture, require_matplotlib, section_picture, view_of

if TYPE_CHECKING:
    from ..api import Progress
    from ..stack import PlyStack, StackPly

DEGREE = "\N{DEGREE SIGN}"
NOTHING = "\N{EN DASH}"
REFERENCES = {"tool": "the first ply's bottom", "middle": "the middle of the stack", "top": "the last ply's top"}

_STYLE = """
body { font: 15px/1.45 "Segoe UI", "DejaVu Sans", Arial, sans-serif; color: #1b1f24; background: #fff; margin: 0; }
main { max-width: 62em; margin: 0 auto; padding: 1.5em; }
h1 { font-size: 1.7em; margin: 0 0 .2em; } h2 { font-size: 1.3em; margin: 0 0 .6em; }
p.lead { color: #57606a; margin: 0 0 1.2em; }
table { border-collapse: collapse; } th, td { padding: .28em .7em; border-bottom: 1px solid #d0d7de; text-align: left; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
table.plies { width: 100%; font-size: .92em; } table.plies thead th { border-bottom: 2px solid #57606a; }
section { border-top: 2px solid #d0d7de; padding-top: 1.2em; margin-top: 1.6em; }
.pair { display: flex; flex-wrap: wrap; gap: 1.4em; align-items: flex-start; }
.pair img { max-width: 100%; border: 1px solid #d0d7de; }
.swatch { display: inline-block; width: .9em; height: .9em; border: 1px solid #57606a; vertical-align: -.08em;
  margin-right: .45em; }
a { color: inherit; } nav { font-size: .9em; color: #57606a; margin-top: .8em; }
@media print { section { break-before: page; border: 0; } nav { display: none; } body { font-size: 11px; } }
"""


def export_ply_book(
    stack: "PlyStack",
    path: str,
    title: str = "Ply book",
    rosette: Optional[Rosette] = None,
    progress: "Optional[Progress]" = None,
) -> None:
    """Writes the ply book of a stack: one HTML file that needs no other, to be read on a screen or printed.

    The cover has the layup, the totals and the table of all plies. Every ply has a page with its name, material, angle,
    thickness, distances, the figures of its report, and a picture seen from outside along the outward normal, with the
    fibre direction. All pictures show the same piece of space.

    Args:
        stack: a PlyStack.
        path: the file, ending in .html.
        title: stands on the cover.
        rosette: the axes that the plies' angles refer to. None: the model's x axis on the middle of the surface, or the
            y axis where x stands too steeply on it; or the first axis of the model that stands nowhere on the face.
        progress: called with a fraction from 0 to 1; returning False stops, and nothing is written.

    Raises:
        FileError: the file cannot be written, or Matplotlib is missing.
        ValueError: rows of the layup name different rosettes.
        TypeError: rosette is no Rosette.
        KeyboardInterrupt: progress returned False.
    """
    path = os.fspath(path)
    require_matplotlib()
    view = view_of(stack, rosette)
    pages = []
    for done, (ply, measures) in enumerate(_measured(stack)):
        if progress is not None and progress(done / len(stack.plies)) is False:
            raise KeyboardInterrupt
        pages.append(_page(stack, ply, measures, ply_picture(ply, view)))
    with replacing(path) as temporary:
        with open(temporary, "w", encoding="utf-8") as stream:
            stream.write(_head(title) + _cover(stack, title) + "".join(pages) + "</main></body></html>\n")


def _head(title: str) -> str:
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"/>'
        '<meta name="viewport" content="width=device-width, initial-scale=1"/>'
        f"<title>{escape(title)}</title><style>{_STYLE}</style></head>\n<body><main>\n"
    )


def _cover(stack: "PlyStack", title: str) -> str:
    lead = f"{stack.summary()}. Lengths in mm, angles in degrees. Written by LaminateOffset {_core.__version__}."
    facts = _facts(_totals(stack))
    picture = _image(section_picture(stack), "The plies on top of each other")
    return (
        f'<header id="cover"><h1>{escape(title)}</h1><p class="lead">{escape(lead)}</p>'
        f'<div class="pair">{facts}{picture}</div></header>\n'
        f'<section><h2>Plies</h2><p class="lead">From the tool outwards. Distances count from the lay-up surface along its '
        f"outward normal.</p>{_ply_table(stack)}</section>\n"
    )


def _totals(stack: "PlyStack") -> Iterable[Tuple[str, str]]:
    report = stack.report
    yield "Plies", str(report["plies"])
    yield "Thickness", number(report["thickness"])
    try:
        yield "Layup", stack.layup.notation()
    except LayupError:  # materials without a letter of their own
        pass
    yield "Stacked", "along the outward normal" if report["direction"] == "normal" else "against the outward normal"
    yield "On the lay-up surface", REFERENCES[report["reference"]]
    figures = stack.mass_properties()
    yield "Area of all plies", _area(figures.area)
    yield from _sizes(figures)
    yield "Tolerance", number(report["tolerance"])
    yield "Proven error of surfaces", _proven(report["certified_error"])
    yield "Proven error of edges", _proven(report["edge_error"])
    for warning in report["warnings"]:
        yield "Warning", warning
    for material in figures.materials:
        mass = "mass not known" if material.mass is None else number(material.mass, "kg")
        yield f"Material {material.material}", f"{material.plies} plies, {_area(material.area)}, {mass}"


def _ply_table(stack: "PlyStack") -> str:
    names = ("No.", "Ply", "Material", "Angle", "Thickness", "Bottom", "Middle", "Top", "Mass in kg", "Boundary")
    numeric = set(names) - {"Ply", "Material", "Boundary"}
    rows = "".join(_row(ply, measures) for ply, measures in _measured(stack))
    head = "".join(f"<th{_class(name in numeric)}>{name}</th>" for name in names)
    return f'<table class="plies"><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>'


def _measured(stack: "PlyStack") -> "List[Tuple[StackPly, PlyProperties]]":
    """Every ply with its area, volume and mass."""
    return list(zip(stack.plies, stack.mass_properties().plies))


def _sizes(measures: Any) -> Iterable[Tuple[str, str]]:
    yield "Volume", number(measures.volume * 1e-3, "cm3")
    yield "Mass", number(measures.mass, "kg")
    yield "Centre of gravity", _place(measures.center)


def _row(ply: "StackPly", measures: PlyProperties) -> str:
    physical, row = ply.ply, ply.ply.ply
    name = f'{_swatch(angle_colour(row.angle))}<a href="#ply{physical.number}">{escape(physical.name)}</a>'
    levels = (physical.thickness, physical.bottom, physical.middle, physical.top)
    cells = [
        (str(physical.number), True),
        (name, False),
        (escape(row.material), False),
        (f"{row.angle:g}{DEGREE}", True),
        *((_length(level), True) for level in levels),
        (NOTHING if measures.mass is None else f"{measures.mass:.4g}", True),
        (escape(row.boundary) or NOTHING, False),
    ]
    return "<tr>" + "".join(f"<td{_class(right)}>{text}</td>" for text, right in cells) + "</tr>\n"


def _page(stack: "PlyStack", ply: "StackPly", measures: PlyProperties, picture: bytes) -> str:
    physical = ply.ply
    title = f"{_swatch(angle_colour(physical.ply.angle))}Ply {physical.number}: {escape(physical.name)}"
    image = _image(picture, f"Ply {physical.name} from outside, fibres at {physical.ply.angle:g} degrees")
    return (
        f'<section id="ply{physical.number}"><h2>{title}</h2><div class="pair">{image}{_facts(_figures(stack, ply, measures))}</div>'
        '<nav><a href="#cover">Back to the cover</a></nav></section>\n'
    )


def _figures(stack: "PlyStack", ply: "StackPly", measures: PlyProperties) -> Iterable[Tuple[str, str]]:
    physical, row, report = ply.ply, ply.ply.ply, ply.report
    yield "Material", row.material
    for material in stack.layup.materials:
        if material.name == row.material and material.description:
            yield "", material.description
    yield "Angle", f"{row.angle:g}{DEGREE}" + (f" from rosette {row.rosette}" if row.rosette else "")
    yield "Thickness", f"{_length(physical.thickness)} mm"
    yield "Bottom, middle, top", ", ".join(map(_length, (physical.bottom, physical.middle, physical.top))) + " mm"
    yield "Boundary", row.boundary or "the whole face"
    yield "Area", _area(measures.area)
    yield from _sizes(measures)
    yield "Surface", surface_type(report["surface"])
    more = ", where all plies below are present" if ply.over_ramp else ""
    yield "At distance", f"{_length(report['distance'])} mm{more}"
    yield "Proven error of surface", _proven(report["certified_error"])
    yield "Proven error of edges", _proven(report["edge_error"])


def _facts(pairs: Iterable[Tuple[str, str]]) -> str:
    rows = "".join(f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in pairs)
    return f"<table>{rows}</table>"


def _image(png: bytes, text: str) -> str:
    return f'<img alt="{escape(text)}" src="data:image/png;base64,{base64.b64encode(png).decode("ascii")}"/>'


def _swatch(colour: Colour) -> str:
    red, green, blue = (round(255 * part) for part in colour)
    return f'<span class="swatch" style="background:#{red:02x}{green:02x}{blue:02x}"></span>'


def _class(right: bool) -> str:
    return ' class="number"' if right else ""


def _proven(error: Any) -> str:
    return "not proven" if error is None else number(error)


def _length(value: float) -> str:
    """A length with its digits down to the micrometre."""
    return f"{round(value, 6) + 0.0:.7g}"


def _place(point: Any) -> str:
    return "({:.6g}, {:.6g}, {:.6g}) mm".format(*(round(value, 6) + 0.0 for value in point))


def _area(square_millimetres: float) -> str:
    return number(square_millimetres * 1e-6, "m2")
