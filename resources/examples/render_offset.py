# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a picture (PNG) of a base face and its offset without a screen.

Usage: render_offset.py BASE OFFSET OUT.png [--report R.json] [--subject TEXT] [--renderer auto|freecad|matplotlib]

BASE and OFFSET are STEP, IGES or BREP files in mm, the report is that of laminate-offset and gives the caption its
figures. The picture is true to scale. The FreeCAD renderer draws FreeCAD's own 3-D
view on a virtual X server (xvfb-run); auto falls back to a Matplotlib drawing when that fails and says so.
"""

import argparse
import importlib
import json
import os
import subprocess
import sys
import tempfile
from typing import List, Optional, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.patches  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
BASE_COLOUR = (0.62, 0.70, 0.82)
OFFSET_COLOUR = (1.00, 0.66, 0.20)
SIGHT = (0.60, 0.70, -0.75)  # direction in which the camera looks, z upwards
VIEW_SIZE = (3600, 2400)  # pixels of the raw view; it is cropped and halved
FREECAD_TIMEOUT_S = 120
USER_CONFIGURATION = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText></FCParamGroup>
<FCParamGroup Name="MainWindow"><FCBool Name="StartupSplash" Value="0"/></FCParamGroup>
<FCParamGroup Name="Document"><FCBool Name="CreateNewDoc" Value="0"/></FCParamGroup>
<FCParamGroup Name="View"><FCBool Name="ShowNaviCube" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="DoNotShowOnOpen" Value="1"/></FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def freecad_view(base: str, offset: str) -> np.ndarray:
    """Picture of FreeCAD's 3-D view as an array (rows, columns, 3) from 0 to 1."""
    with tempfile.TemporaryDirectory(prefix="laminate_offset_render_") as folder:
        files = {name: os.path.join(folder, name) for name in ("view.png", "request.json", "user.cfg", "system.cfg")}
        request = {
            "base": os.path.abspath(base),
            "offset": os.path.abspath(offset),
            "picture": files["view.png"],
            "width": VIEW_SIZE[0],
            "height": VIEW_SIZE[1],
            "base_colour": BASE_COLOUR,
            "offset_colour": OFFSET_COLOUR,
            "view": SIGHT,
        }
        with open(files["request.json"], "w", encoding="utf-8") as stream:
            json.dump(request, stream)
        with open(files["user.cfg"], "w", encoding="utf-8") as stream:
            stream.write(USER_CONFIGURATION)
        run_freecad(folder, files)
        return plt.imread(files["view.png"])[:, :, :3]


def run_freecad(folder: str, files: dict) -> None:
    """Runs FreeCAD's GUI on a virtual screen until the picture stands; raises RuntimeError with the reason."""
    environment = dict(os.environ, RENDER_REQUEST=files["request.json"], LIBGL_ALWAYS_SOFTWARE="1", HOME=folder)
    environment.update(QTWEBENGINE_DISABLE_SANDBOX="1", QT_QPA_PLATFORM="xcb", XDG_RUNTIME_DIR=folder)
    command = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24", "freecad"]
    command += ["-u", files["user.cfg"], "-s", files["system.cfg"], os.path.join(HERE, "render_freecad_view.py")]
    try:
        done = subprocess.run(
            command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=FREECAD_TIMEOUT_S
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise RuntimeError(str(error)) from error
    if done.returncode != 0 or not os.path.exists(files["view.png"]):
        raise RuntimeError("FreeCAD ended with exit code %d:\n%s" % (done.returncode, done.stdout.decode()[-1000:]))


def shaded_triangles(shape, colour: Sequence[float], alpha: float):
    """Shaded Matplotlib triangles of a shape, and its edge lines as point arrays."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    points, facets = shape.tessellate(0.002 * shape.BoundBox.DiagonalLength)
    corners = np.array([tuple(point) for point in points])[np.array(facets)]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    light = np.abs(normals @ (np.array(SIGHT) / np.linalg.norm(SIGHT)))
    faces = np.clip(np.outer(0.35 + 0.65 * light, colour), 0.0, 1.0)
    triangles = Poly3DCollection(corners, facecolors=np.column_stack((faces, np.full(len(faces), alpha))))
    triangles.set_antialiased(False)  # smoothed triangle borders would show as a pale web
    lines = [np.array([tuple(point) for point in edge.discretize(80)]) for edge in shape.Edges]
    return triangles, lines


def matplotlib_view(base: str, offset: str) -> np.ndarray:
    """The same picture drawn by Matplotlib."""
    sys.path.append("/usr/lib/freecad-python3/lib")
    importlib.import_module("FreeCAD")  # Part needs it loaded first
    Part = importlib.import_module("Part")
    figure = plt.figure(figsize=(VIEW_SIZE[0] / 200, VIEW_SIZE[1] / 200), dpi=200)
    axes = figure.add_axes((0, 0, 1, 1), projection="3d", proj_type="ortho")
    shapes: List[object] = [Part.read(base), Part.read(offset)]
    for shape, colour, alpha in zip(shapes, (BASE_COLOUR, OFFSET_COLOUR), (1.0, 0.75)):
        triangles, lines = shaded_triangles(shape, colour, alpha)
        axes.add_collection3d(triangles)
        for line in lines:
            axes.plot(*line.T, color=[0.35 * part for part in colour], linewidth=1.0)
    box = shapes[0].BoundBox
    box.add(shapes[1].BoundBox)
    for limit, low, high in ((axes.set_xlim, box.XMin, box.XMax), (axes.set_ylim, box.YMin, box.YMax)):
        limit(low, high)
    axes.set_zlim(box.ZMin, box.ZMax)
    axes.set_box_aspect((box.XLength, box.YLength, box.ZLength))
    elevation = np.degrees(np.arcsin(-SIGHT[2] / np.linalg.norm(SIGHT)))
    axes.view_init(elevation, np.degrees(np.arctan2(-SIGHT[1], -SIGHT[0])))
    axes.set_axis_off()
    figure.canvas.draw()
    image = np.asarray(figure.canvas.buffer_rgba())[:, :, :3] / 255.0
    plt.close(figure)
    return image


def cropped(image: np.ndarray, margin: int = 40) -> np.ndarray:
    """The image without its white border, halved in size by averaging (smooth edges)."""
    ink = np.argwhere(image.min(axis=2) < 0.99)
    if len(ink) == 0:
        raise RuntimeError("the rendered view is empty")
    low, high = ink.min(axis=0), ink.max(axis=0) + 1
    image = np.pad(image[low[0] : high[0], low[1] : high[1]], ((margin,) * 2, (margin,) * 2, (0, 0)), constant_values=1)
    rows, columns = (size // 2 * 2 for size in image.shape[:2])
    return image[:rows, :columns].reshape(rows // 2, 2, columns // 2, 2, 3).mean(axis=(1, 3))


def compose(image: np.ndarray, caption: str, path: str) -> None:
    """Writes the view with its legend above and the caption below; the file is replaced in one step."""
    dpi, band = 100, 90
    height, width = image.shape[:2]
    figure = plt.figure(figsize=(width / dpi, (height + band) / dpi), dpi=dpi)
    axes = figure.add_axes((0.0, band / (height + band), 1.0, height / (height + band)))
    axes.imshow(np.clip(image, 0.0, 1.0), interpolation="none")
    axes.set_axis_off()
    named = (("base face", BASE_COLOUR), ("offset face", OFFSET_COLOUR))
    handles = [matplotlib.patches.Patch(facecolor=colour, edgecolor="0.3", label=name) for name, colour in named]
    figure.legend(handles=handles, loc="upper left", frameon=False, fontsize=13)
    figure.text(0.5, 0.5 * band / (height + band), caption, ha="center", va="center", fontsize=12, color="0.15")
    temporary = path + ".part.png"
    figure.savefig(temporary, dpi=dpi, pil_kwargs={"optimize": True})
    plt.close(figure)
    os.replace(temporary, path)


def caption_text(subject: str, report_path: Optional[str]) -> str:
    """What the picture shows, with the figures of the report when there is one."""
    if report_path is None:
        return "%s and its offset, true to scale." % subject
    with open(report_path, encoding="utf-8") as stream:
        report = json.load(stream)
    if isinstance(report, list):
        report = report[0]
    surface, error = report["surface"], report["certified_error"]
    kind = "proven" if error is not None else "sampled"
    error = report["sampled_error"] if error is None else error
    deviation = "exact surface" if error is None else "%s deviation %.2g mm" % (kind, error)
    poles = surface["poles_u"] * surface["poles_v"]
    size = "%d x %d poles" % (surface["poles_u"], surface["poles_v"]) if poles else surface["type"]
    first = "%s and its offset at %g mm, true to scale." % (subject, report["distance"])
    return "%s\n%s, %s (tolerance %g mm)." % (first, size, deviation, report["tolerance"])


def rendered(base: str, offset: str, renderer: str) -> np.ndarray:
    """The view by the wanted renderer."""
    if renderer == "matplotlib":
        return matplotlib_view(base, offset)
    try:
        return freecad_view(base, offset)
    except RuntimeError as error:
        if renderer == "freecad":
            raise
        print("FreeCAD's 3-D view could not be drawn, Matplotlib draws instead: %s" % error, file=sys.stderr)
        return matplotlib_view(base, offset)


def main(arguments: Sequence[str]) -> int:
    """Runs the command; returns its exit code."""
    parser = argparse.ArgumentParser(description="Picture of a base face and its offset.")
    parser.add_argument("base")
    parser.add_argument("offset")
    parser.add_argument("out")
    parser.add_argument("--report")
    parser.add_argument("--subject", default="A face")
    parser.add_argument("--renderer", choices=("auto", "freecad", "matplotlib"), default="auto")
    options = parser.parse_args(arguments)
    for path in (options.base, options.offset):
        if not os.path.isfile(path):
            parser.error("no such model file: %s" % path)
    caption = caption_text(options.subject, options.report)
    compose(cropped(rendered(options.base, options.offset, options.renderer)), caption, options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
