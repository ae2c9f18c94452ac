# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of trimmed faces for reproduce_table1.py: true to scale in space, and in the parameters of their surfaces.

Drawn by Matplotlib without a screen. Every picture is a PNG file, replaced in one step.
"""

import os
from dataclasses import dataclass, field
from typing import Iterator, List, Sequence, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.patches  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402  (Matplotlib needs it, too)
from matplotlib.collections import PolyCollection  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402

Colour = Tuple[float, float, float]
BASE: Colour = (0.62, 0.70, 0.82)
OFFSET: Colour = (1.00, 0.66, 0.20)
EXTENDED: Colour = (0.72, 0.86, 0.66)
LOOPS: Tuple[str, ...] = ("tab:red", "tab:blue", "tab:purple")  # outer loop first
LIGHT = np.array((0.35, -0.45, 0.82))
EDGE_LIFT = 0.008  # edges stand so much before their surfaces, part of the picture's size
DPI = 110


@dataclass(frozen=True)
class Layer:
    """A shape in a picture."""

    shape: object
    colour: Colour
    name: str
    loops: bool = False  # its loops in the loops' colours, and thick
    lift: float = 0.0  # towards the eye, part of the picture's size: for a shape that lies on another one


@dataclass(frozen=True)
class View:
    """What one panel shows, and from where (degrees)."""

    title: str
    layers: Sequence[Layer]
    elevation: float = 24.0
    azimuth: float = -58.0


@dataclass(frozen=True)
class Domain:
    """A rectangle of parameters."""

    bounds: Tuple[float, float, float, float]  # u from, u to, v from, v to
    name: str
    style: str = "-"


@dataclass(frozen=True)
class Loop:
    """The curves of a loop in the order and sense in which it runs, as arrays (n, 2)."""

    curves: Sequence[np.ndarray] = field(default_factory=list)

    def area(self) -> float:
        """Signed; positive: anticlockwise."""
        x, y = np.concatenate([curve[:-1] for curve in self.curves]).T
        return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def loops_of(face, count: int = 60) -> List[Loop]:
    """The loops in the parameters of the face's surface, seen along the face's outward normal, the outer one first."""
    wires = sorted(face.Wires, key=lambda wire: not wire.isSame(face.OuterWire))
    return [Loop([run_of(face, edge, count) for edge in wire.OrderedEdges]) for wire in wires]


def run_of(face, edge, count: int) -> np.ndarray:
    """Points of an edge's trimming curve in the edge's own sense."""
    curve, first, last = face.curveOnSurface(edge)
    points = np.array([(p.x, p.y) for p in (curve.value(float(t)) for t in np.linspace(first, last, count + 1))])
    return points[::-1] if edge.Orientation == "Reversed" else points


def direction(view: View) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit vectors to the right, upwards and towards the eye."""
    e, a = np.radians((view.elevation, view.azimuth))
    eye = np.array((np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)))
    right = np.array((-np.sin(a), np.cos(a), 0.0))
    return right, np.cross(eye, right), eye


def facets_of(layer: Layer, size: float) -> Tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3, 3) and shaded colours (n, 3) of a shape's facets, none longer than `size`."""
    points, facets = layer.shape.tessellate(0.05 * size)
    corners = np.array([tuple(point) for point in points])[np.array(facets)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    light = np.abs(normals @ (LIGHT / np.linalg.norm(LIGHT)))
    return divided(corners, np.clip(np.outer(0.45 + 0.55 * light, layer.colour), 0.0, 1.0), size)


def divided(corners: np.ndarray, colours: np.ndarray, size: float) -> Tuple[np.ndarray, np.ndarray]:
    """Halves facets across their longest sides: they are drawn in the order of their middles."""
    while True:
        lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
        long = lengths.max(axis=1) > size
        if not long.any():
            return corners, colours
        side = lengths[long].argmax(axis=1)
        rows = np.arange(len(side))
        a, b, c = (corners[long][rows, (side + k) % 3] for k in range(3))
        middle = 0.5 * (a + b)
        halves = [np.stack((a, middle, c), axis=1), np.stack((middle, b, c), axis=1)]
        corners = np.concatenate((corners[~long], *halves))
        colours = np.concatenate((colours[~long], colours[long], colours[long]))


def lines_of(layer: Layer, size: float) -> Iterator[Tuple[np.ndarray, Colour]]:
    """Points along every edge, and the edge's colour."""
    face = layer.shape.Faces[0]
    inner = iter(LOOPS[1:])
    for wire in face.Wires:
        colour = LOOPS[0] if wire.isSame(face.OuterWire) else next(inner)
        for edge in wire.Edges:
            if not edge.Degenerated:
                count = max(2, int(edge.Length / (0.5 * size)) + 2)
                dark = tuple(0.4 * part for part in layer.colour)
                yield np.array([tuple(p) for p in edge.discretize(count)]), to_rgb(colour) if layer.loops else dark


def ribbon(flat: np.ndarray, width: float) -> np.ndarray:
    """Quadrangles (n, 4, 2) along a line of the picture."""
    along = np.diff(flat, axis=0)
    length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    across = 0.5 * width * np.column_stack((-along[:, 1], along[:, 0])) / length
    lap = 0.3 * width * along / length  # over the next one
    a, b = flat[:-1] - lap, flat[1:] + lap
    return np.stack((a - across, b - across, b + across, a + across), axis=1)


def size_of(layers: Sequence[Layer]) -> float:
    """The diagonal of the box around all shapes."""
    boxes = [layer.shape.BoundBox for layer in layers]
    low = np.min([(box.XMin, box.YMin, box.ZMin) for box in boxes], axis=0)
    high = np.max([(box.XMax, box.YMax, box.ZMax) for box in boxes], axis=0)
    return float(np.linalg.norm(high - low))


def draw_view(axes, view: View) -> None:
    """Draws the layers, true to scale: facets and edges together from the farthest to the nearest."""
    right, up, eye = direction(view)
    diagonal = size_of(view.layers)
    size = 0.012 * diagonal
    polygons, colours, depths = [], [], []
    for layer in view.layers:
        corners, shades = facets_of(layer, size)
        polygons += list(np.stack((corners @ right, corners @ up), axis=2))
        colours += list(shades)
        depths += list(corners.mean(axis=1) @ eye + layer.lift * diagonal)
        for line, colour in lines_of(layer, size):
            flat = np.column_stack((line @ right, line @ up))
            polygons += list(ribbon(flat, (0.007 if layer.loops else 0.0025) * diagonal))
            colours += [np.array(colour)] * (len(line) - 1)
            depths += list(0.5 * (line[1:] + line[:-1]) @ eye + (layer.lift + EDGE_LIFT) * diagonal)
    order = np.argsort(depths)
    drawn = [colours[k] for k in order]
    axes.add_collection(PolyCollection([polygons[k] for k in order], facecolors=drawn, edgecolors=drawn, lw=0.3))
    axes.autoscale_view()
    axes.margins(0.02)
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set_title(view.title, fontsize=11)


def save(figure, path: str) -> None:
    """Writes the figure without its white border, in 128 colours."""
    temporary = path + ".part.png"
    figure.savefig(temporary, dpi=DPI, bbox_inches="tight", pad_inches=0.1)
    plt.close(figure)
    with Image.open(temporary) as picture:
        few = picture.convert("RGB").quantize(128)
    few.save(temporary, optimize=True)
    os.replace(temporary, path)


def draw_in_space(path: str, title: str, views: Sequence[View]) -> None:
    """One panel a view, a legend of all layers below."""
    figure, panels = plt.subplots(1, len(views), figsize=(7.0 * len(views), 5.0), squeeze=False)
    for axes, view in zip(panels[0], views):
        draw_view(axes, view)
    named = {layer.name: layer.colour for view in views for layer in view.layers}
    handles = [matplotlib.patches.Patch(facecolor=c, edgecolor="0.3", label=name) for name, c in named.items()]
    figure.suptitle(title, fontsize=12, y=0.99)
    figure.tight_layout(rect=(0.0, 0.07, 1.0, 0.98))
    figure.legend(handles=handles, loc="lower center", ncol=len(handles), frameon=False, fontsize=10)
    save(figure, path)


def draw_in_parameters(path: str, title: str, domains: Sequence[Domain], loops: Sequence[Loop]) -> None:
    """Loops with their sense, every curve between two dots, inside the rectangles of a surface's parameters."""
    figure, axes = plt.subplots(figsize=(9.0, 6.5))
    for domain in domains:
        u0, u1, v0, v1 = domain.bounds
        axes.plot([u0, u1, u1, u0, u0], [v0, v0, v1, v1, v0], domain.style, color="0.35", lw=1.2, label=domain.name)
    for k, loop in enumerate(loops):
        sense = "anticlockwise" if loop.area() > 0.0 else "clockwise"
        name = "%s loop, %s" % ("outer" if k == 0 else "inner", sense)
        for i, curve in enumerate(loop.curves):
            axes.plot(*curve.T, color=LOOPS[k % len(LOOPS)], lw=1.6, label=name if i == 0 else None)
            axes.plot(*curve[0], "o", color=LOOPS[k % len(LOOPS)], ms=4)
            middle = len(curve) // 2
            axes.annotate(
                "",
                curve[middle + 1],
                curve[middle - 1],
                arrowprops={"arrowstyle": "-|>", "color": LOOPS[k % len(LOOPS)], "mutation_scale": 18},
            )
    axes.set(xlabel="u", ylabel="v", title=title)
    axes.set_aspect("equal")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2, frameon=False, fontsize=9)
    save(figure, path)
