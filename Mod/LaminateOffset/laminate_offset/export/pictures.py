# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of plies with Matplotlib, without a screen: seen from outside, with the fibre direction.

Matplotlib draws flat figures only here: the surface is projected and shaded by us, which is some ten times as fast as
its own drawing of surfaces in space, and hides what lies behind.
"""

import importlib
import io
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy

from ..ply_colours import Colour, angle_colour
from ..replacing import FileError
from ..rosette import Rosette
from .fibres import Array, Axes, axes_of, fibre_directions
from .triangles import crossed, triangles_of

if TYPE_CHECKING:
    from ..stack import PlyStack, StackPly

WIDTH, LOWEST, HIGHEST, DPI = 6.4, 2.6, 5.6, 110  # width and range of heights in inches, and pixels per inch
STRIP = 0.5  # inches at the bottom, for the scale
DEVIATION = 3e-4  # of triangles and lines, of the stack's size
ANGLE = 0.1  # radians between neighbouring triangles
DASHES = 18  # fibre strokes across the larger side of a ply
# Mean normals shorter than this: the surface closes on itself, and no side of it shows all.
CLOSED = 0.3
_LIGHT = numpy.array((-0.35, 0.45, 0.82))


@dataclass(frozen=True)
class View:
    """How the stack is looked at; the same for all of its plies.

    Attributes:
        right, up, towards: unit vectors of the picture; the last points to the eye.
        low, high: corners of what is shown, in mm along right and up.
        axes: what the angles refer to.
        outline: lines of the lay-up surface's edges, each an array (n, 2).
    """

    right: Array
    up: Array
    towards: Array
    low: Array
    high: Array
    axes: Axes
    outline: Tuple[Array, ...]

    @property
    def size(self) -> float:
        """The diagonal of what is shown, in mm."""
        return float(numpy.linalg.norm(self.high - self.low))

    def flat(self, points: Array) -> Array:
        """Points or directions in the picture's plane."""
        return numpy.stack((points @ self.right, points @ self.up), axis=-1)


class Mesh:
    """Triangles of a face: corners (n, 3, 3), outward unit normals (n, 3) and areas (n,)."""

    def __init__(self, face: Any, deviation: float) -> None:
        points, triangles = triangles_of(face, deviation, ANGLE)
        self.corners = points[triangles]
        normals = crossed(self.corners)
        lengths = numpy.linalg.norm(normals, axis=1)
        self.normals = normals / lengths[:, None]
        self.areas = 0.5 * lengths


def require_matplotlib() -> None:
    """Raises FileError where Matplotlib is missing."""
    try:
        importlib.import_module("matplotlib.figure")
    except ImportError as error:
        raise FileError(
            f"Pictures of plies need Matplotlib (on Debian: apt-get install python3-matplotlib): {error}."
        ) from error


def view_of(stack: "PlyStack", rosette: Optional[Rosette] = None) -> View:
    """From outside, along the mean normal of the lay-up surface, with the first axis to the right.

    A surface that closes on itself is seen at a slant.
    """
    face = stack.base_face
    deviation = DEVIATION * face.BoundBox.DiagonalLength
    mesh = Mesh(face, deviation)
    mean = (mesh.normals * mesh.areas[:, None]).sum(axis=0) / mesh.areas.sum()
    axes = axes_of(stack, rosette)
    towards, right = mean, axes.first
    if numpy.linalg.norm(mean) < CLOSED:
        towards, right = numpy.array((1.0, -1.2, 0.8)), numpy.array((1.2, 1.0, 0.0))
    towards = towards / numpy.linalg.norm(towards)
    right = right - (right @ towards) * towards
    right = right / numpy.linalg.norm(right)
    up = numpy.cross(towards, right)
    projection = numpy.stack((right, up), axis=-1)
    # All plies lie between the first one's bottom and the last one's top.
    shown = [mesh, Mesh(stack.bottom_face, deviation), Mesh(stack.top_face, deviation)]
    ends = numpy.concatenate([each.corners.reshape(-1, 3) for each in shown]) @ projection
    outline = tuple(line @ projection for line in _edges(face, deviation))
    return View(right, up, towards, ends.min(axis=0), ends.max(axis=0), axes, outline)


def ply_picture(ply: "StackPly", view: View) -> bytes:
    """One ply as PNG: shaded in the colour of its angle, with the fibres' directions, an arrow and a scale."""
    mesh = Mesh(ply.face, DEVIATION * view.size)
    figure, axes = _figure(view)
    _draw_lines(axes, view.outline, "0.72", 0.8)
    _draw_mesh(axes, mesh, view, angle_colour(ply.ply.ply.angle))
    _draw_lines(axes, [view.flat(line) for line in _edges(ply.face, DEVIATION * view.size)], "0.15", 1.0)
    _draw_directions(axes, mesh, view, ply.ply.ply.angle)
    _draw_scale(axes, view)
    return _png(figure)


def section_picture(stack: "PlyStack") -> bytes:
    """The plies on top of each other as PNG: heights are thicknesses, colours are angles."""
    from matplotlib.figure import Figure

    plies = [ply.ply for ply in stack.plies]
    figure = Figure(figsize=(3.2, 4.8), dpi=DPI)
    axes = figure.add_axes((0.2, 0.04, 0.76, 0.92))
    height = 0.0
    labelled = len(plies) <= 40
    for ply in plies:
        colour = angle_colour(ply.ply.angle)
        line = 0.6 if labelled else 0.0
        axes.bar(0.5, ply.thickness, 1.0, bottom=height, color=colour, edgecolor="0.15", linewidth=line)
        if labelled:
            text = f"{ply.name}  {ply.ply.angle:g}\N{DEGREE SIGN}"
            ink = "white" if sum(colour) < 1.45 else "black"
            middle = height + 0.5 * ply.thickness
            axes.text(0.5, middle, text, ha="center", va="center", fontsize=7, color=ink, clip_on=True)
        height += ply.thickness
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, height)
    axes.set_xticks([])
    axes.set_ylabel("mm from the tool surface", fontsize=8)
    axes.tick_params(labelsize=7)
    return _png(figure)


def _figure(view: View) -> Tuple[Any, Any]:
    """A figure without axes whose units are mm of the view, with space around it."""
    from matplotlib.figure import Figure

    middle, extent = 0.5 * (view.low + view.high), numpy.maximum(view.high - view.low, 1e-9)
    border = 0.25
    room = HIGHEST - STRIP - 2.0 * border
    scale = max(extent[0] / (WIDTH - 2.0 * border), extent[1] / room)  # mm per inch
    height = max(extent[1] / scale + STRIP + 2.0 * border, LOWEST)
    figure = Figure(figsize=(WIDTH, height), dpi=DPI)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(middle[0] - 0.5 * scale * WIDTH, middle[0] + 0.5 * scale * WIDTH)
    axes.set_ylim(middle[1] - 0.5 * scale * (height + STRIP), middle[1] + 0.5 * scale * (height - STRIP))
    return figure, axes


def _png(figure: Any) -> bytes:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    FigureCanvasAgg(figure)
    stream = io.BytesIO()
    figure.savefig(stream, format="png")
    return stream.getvalue()


def _edges(shape: Any, deviation: float) -> List[Array]:
    """The edges of a face or shell as arrays (n, 3) of points; seams and poles are no borders."""
    edges = [edge for face in shape.Faces for edge in face.Edges if not edge.Degenerated and not edge.isSeam(face)]
    return [
        numpy.array([tuple(point) for point in edge.discretize(Angular=ANGLE, Curvature=deviation)]) for edge in edges
    ]


def _draw_lines(axes: Any, lines: Any, colour: str, width: float) -> None:
    for line in lines:
        axes.plot(line[:, 0], line[:, 1], color=colour, linewidth=width, solid_capstyle="round")


def _draw_mesh(axes: Any, mesh: Mesh, view: View, colour: Colour) -> None:
    """The triangles from the farthest to the nearest, lit from the upper left; their backs are darker."""
    from matplotlib.collections import PolyCollection

    light = _LIGHT[0] * view.right + _LIGHT[1] * view.up + _LIGHT[2] * view.towards
    light /= numpy.linalg.norm(light)
    front = mesh.normals @ view.towards >= 0.0
    facing = numpy.where(front[:, None], mesh.normals, -mesh.normals)
    shade = 0.35 + 0.65 * numpy.clip(facing @ light, 0.0, 1.0)
    shade = numpy.where(front, shade, 0.6 * shade)[:, None]
    # Tinted towards white, so that lines and arrows stand out.
    tint = 0.35 + 0.65 * numpy.array(colour)
    order = numpy.argsort(mesh.corners.mean(axis=1) @ view.towards)
    colours = numpy.clip(shade * tint, 0.0, 1.0)[order]
    triangles = view.flat(mesh.corners)[order]
    axes.add_collection(PolyCollection(triangles, facecolors=colours, edgecolors=colours, linewidths=0.3))


class Seen:
    """Which triangle is seen at a place of the picture."""

    def __init__(self, mesh: Mesh, view: View) -> None:
        keep = mesh.normals @ view.towards > 0.1
        corners = view.flat(mesh.corners[keep])
        self._normals = mesh.normals[keep]
        self._heights = mesh.corners[keep].mean(axis=1) @ view.towards
        self._start = corners[:, 0]
        one, other = corners[:, 1] - self._start, corners[:, 2] - self._start
        self._twice = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
        self._one, self._other = one, other

    def normals_at(self, places: Array) -> Tuple[Array, Array]:
        """Whether an outer side is seen at places (n, 2), and the outward normals there (n, 3)."""
        inside = numpy.zeros(len(places), dtype=bool)
        normals = numpy.zeros((len(places), 3))
        for index, place in enumerate(places):
            away = place - self._start
            first = (away[:, 0] * self._other[:, 1] - away[:, 1] * self._other[:, 0]) / self._twice
            second = (self._one[:, 0] * away[:, 1] - self._one[:, 1] * away[:, 0]) / self._twice
            hit = numpy.flatnonzero((first >= 0.0) & (second >= 0.0) & (first + second <= 1.0))
            if hit.size:
                inside[index] = True
                normals[index] = self._normals[hit[numpy.argmax(self._heights[hit])]]
        return inside, normals


def _grid(mesh: Mesh, view: View) -> Tuple[Array, float]:
    """Places all over a ply, every second row shifted by half a step, and the step."""
    points = view.flat(mesh.corners.reshape(-1, 3))
    low, high = points.min(axis=0), points.max(axis=0)
    extent = high - low
    # A ply on a small part of the face has more strokes than its share of the picture.
    step = max(float(extent.max()), 0.35 * float((view.high - view.low).max())) / DASHES
    columns, rows = (numpy.arange(-0.5, 0.5 * extent[k] / step + 1.0) for k in (0, 1))
    columns, rows = (numpy.concatenate((-values[::-1], values[values > 0.5])) for values in (columns, rows))
    centre = 0.5 * (low + high)
    places = [
        centre + step * numpy.array((column + 0.5 * (index % 2), row))
        for index, row in enumerate(rows)
        for column in columns
    ]
    return numpy.array(places), step


def _draw_directions(axes: Any, mesh: Mesh, view: View, angle: float) -> None:
    """Strokes along the fibres, and near the middle an arrow along them and one along the first axis."""
    from matplotlib.collections import LineCollection

    seen = Seen(mesh, view)
    places, step = _grid(mesh, view)
    inside, normals = seen.normals_at(places)
    places, normals = places[inside], normals[inside]
    if not len(places):
        return
    directions = view.flat(fibre_directions(view.axes, normals, angle))
    ends = [places + sign * 0.3 * step * directions for sign in (-1.0, 1.0)]
    whole = seen.normals_at(ends[0])[0] & seen.normals_at(ends[1])[0]
    strokes = numpy.stack(ends, axis=1)[whole]
    axes.add_collection(LineCollection(strokes, colors=[(0.0, 0.0, 0.0, 0.4)], linewidths=0.9))
    length = 2.2 * step
    firsts = view.flat(fibre_directions(view.axes, normals, 0.0))
    # The arrows start where they stay on the ply, as near to its middle as may be.
    far = numpy.linalg.norm(places - places.mean(axis=0), axis=1) / view.size
    for share in (-0.2, 0.5, 1.0):
        far += ~seen.normals_at(places + share * length * directions)[0]
        far += 0.5 * ~seen.normals_at(places + share * length * firsts)[0]
    best = int(numpy.argmin(far))
    if angle % 180.0:
        _draw_arrow(axes, places[best], length * firsts[best], "0.25", 1.2, 0.0)
    _draw_arrow(axes, places[best], length * directions[best], "black", 2.6, angle)


def _draw_arrow(axes: Any, start: Array, along: Array, colour: str, width: float, angle: float) -> None:
    """An arrow with its angle beside the tip."""
    end = start + along
    arrow: Dict[str, Any] = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", xy=end, xytext=start, arrowprops={**arrow, "mutation_scale": 9 + 3 * width})
    box = {"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.75}
    text = f"{angle:g}\N{DEGREE SIGN}"
    place = end + 0.18 * along
    axes.text(*place, text, ha="center", va="center", fontsize=11, color=colour, bbox=box)


def _draw_scale(axes: Any, view: View) -> None:
    """A bar of a round length, and the directions of the model's axes."""
    left, right = axes.get_xlim()
    inch = (right - left) / WIDTH
    base = axes.get_ylim()[0]
    longest = 1.6 * inch
    step = 10.0 ** math.floor(math.log10(longest))
    length = max(step * factor for factor in (1, 2, 5) if step * factor <= longest)
    x, y = left + 0.2 * inch, base + 0.22 * inch
    axes.plot((x, x + length), (y, y), color="0.15", linewidth=2.0, solid_capstyle="butt")
    axes.text(x + length + 0.08 * inch, y, f"{length:g} mm", va="center", fontsize=9, color="0.15")
    corner, size = numpy.array((right - 0.6 * inch, base + 0.4 * inch)), 0.28 * inch
    for axis, name in zip(numpy.eye(3), "xyz"):
        end = view.flat(axis) * size
        if numpy.linalg.norm(end) > 0.25 * size:
            axes.annotate("", xy=corner + end, xytext=corner, arrowprops={"arrowstyle": "->", "color": "0.35"})
            axes.text(*(corner + 1.3 * end), name, ha="center", va="center", fontsize=8, color="0.35")
