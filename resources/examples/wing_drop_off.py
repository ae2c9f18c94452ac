# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two patches and a staggered drop-off of five plies on a wing skin, measured independently and drawn.

    PYTHONPATH=/usr/lib/freecad-python3/lib python3 wing_drop_off.py --out FOLDER

(this folder is <add-on>/resources/examples). It lays nine plies of 0.25 mm with ramps of 1:20, follows lines along the
skin's normals through all plies with OpenCASCADE's evaluation alone, prints what it finds as JSON and writes it with the
picture to the folder. Exit codes: 0 all as it should be; 1 it is not.
"""

import argparse
import json
import os
import sys

# The add-on is two folders up; inside FreeCAD it is on the path anyway.
sys.path.append(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))

import laminate_offset as lo  # noqa: E402  (finds FreeCAD's modules, too)
import numpy  # noqa: E402
import Part  # noqa: E402

SKIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "naca_wing_skin.step")
THICKNESS = 0.25
TOLERANCE = 1e-3
STAGGER = [0, 8, 16, 24, 32]
DROP_OFF = 1900  # where the longest of the staggered plies ends, along the span
ROWS = ["", "patch A", "tip", "tip", "patch B", "tip", "tip", "tip", ""]


def iso_rectangle(surface, u0, u1, v0, v1):
    """A wire along parameter lines."""
    sides = [
        (surface.vIso(v0), u0, u1),
        (surface.uIso(u1), v0, v1),
        (surface.vIso(v1), u0, u1),
        (surface.uIso(u0), v0, v1),
    ]
    return Part.Wire([curve.toShape(first, last) for curve, first, last in sides])


def lay(face):
    """The stack."""
    surface = face.Surface
    u0, u1, _, _ = face.ParameterRange
    boundaries = {
        "patch A": iso_rectangle(surface, 300, 500, 600, 1000),
        "patch B": iso_rectangle(surface, 400, 700, 850, 1300),
        "tip": lo.Boundary(surface.vIso(DROP_OFF).toShape(u0, u1), side="right"),
    }
    plies = [lo.Ply(f"P{i}", "tape", THICKNESS, boundary=name) for i, name in enumerate(ROWS, 1)]
    return lo.stack_plies(
        face, lo.Layup(tuple(plies)), TOLERANCE, boundaries=boundaries, drop_off=20, stagger={"tip": STAGGER}
    )


def places(face, count):
    """Parameters all over the skin, and as many again where plies end."""
    random = numpy.random.default_rng(5)
    u0, u1, v0, v1 = face.ParameterRange
    boxes = [(u0, u1, v0, v1), (u0, u1, DROP_OFF - 45, DROP_OFF + 10), (290, 520, 590, 1010), (390, 710, 840, 1310)]
    rows = [random.uniform((a, c), (b, d), (count, 2)) for a, b, c, d in boxes]
    for u in (300, 500, 400, 700):  # across the patches' sides
        rows.append(random.uniform((u - 8, 600), (u + 8, 1300), (count // 4, 2)))
    return numpy.concatenate(rows)


def look_through(face, stack, count):
    """Heights along the skin's normals: (n, plies, 2), not a number where a ply is not, and the largest distance of a
    surface's point from its normal."""
    uv = places(face, count)
    uv = uv[[face.isPartOfDomain(u, v) for u, v in uv]]
    heights = numpy.full((len(uv), len(stack.plies), 2), numpy.nan)
    sideways = 0.0
    for i, (u, v) in enumerate(uv):
        foot, normal = face.Surface.value(u, v), face.normalAt(u, v)
        for k, ply in enumerate(stack.plies):
            if not ply.base_face.isPartOfDomain(u, v):
                continue
            for side, surface in enumerate((ply.bottom_face.Surface, ply.top_face.Surface)):
                way = surface.value(u, v) - foot
                heights[i, k, side] = way.dot(normal)
                sideways = max(sideways, (way - normal * way.dot(normal)).Length)
    return uv, heights, sideways


def lines_through(face, stack, uv, heights):
    """The same heights again where straight lines meet the surfaces: the largest difference, and how many met."""
    worst, met = 0.0, 0
    for (u, v), row in zip(uv, heights):
        foot, normal = face.Surface.value(u, v), face.normalAt(u, v)
        line = Part.LineSegment(foot - normal, foot + normal * 5)
        for ply, (_, top) in zip(stack.plies, row):
            if numpy.isnan(top):
                continue
            points = ply.top_face.Surface.intersect(line.toShape().Curve)
            points = points[0] if isinstance(points, tuple) else points
            found = [(point.toShape().Point - foot).dot(normal) for point in points]
            if found:
                worst = max(worst, min(abs(height - top) for height in found))
                met += 1
    return worst, met


def normal_jump(surface):
    """The largest angle in radians between a surface's normals at both sides of its knots."""
    u0, u1, v0, v1 = surface.bounds()
    us, vs = numpy.linspace(u0, u1, 41)[1:-1], numpy.linspace(v0, v1, 41)[1:-1]
    worst = 0.0
    for knots, others, along_u in ((surface.getUKnots(), vs, True), (surface.getVKnots(), us, False)):
        for knot in knots[1:-1]:
            for other in others:
                sides = [
                    surface.normal(*((knot + step, other) if along_u else (other, knot + step)))
                    for step in (-1e-11 * abs(knot), 1e-11 * abs(knot))
                ]
                worst = max(worst, sides[0].getAngle(sides[1]))
    return worst


def figures(face, stack, count):
    """What was measured, in mm and radians."""
    uv, heights, sideways = look_through(face, stack, count)
    thickness = heights[:, :, 1] - heights[:, :, 0]
    below = numpy.fmax.accumulate(numpy.nan_to_num(heights[:, :, 1], nan=0.0), axis=1)
    gap = heights[:, 1:, 0] - below[:, :-1]  # between a ply and the highest of those below it
    line_difference, met = lines_through(face, stack, uv[:: max(1, len(uv) // 40)], heights[:: max(1, len(uv) // 40)])
    return {
        "plies": len(stack.plies),
        "places": len(uv),
        "ply_places": int(numpy.isfinite(thickness).sum()),
        "certified_error": stack.report["certified_error"],
        "edge_error": stack.report["edge_error"],
        "inset_error": stack.report["inset_error"],
        "largest_thickness_error": float(numpy.nanmax(numpy.abs(thickness - THICKNESS))),
        "least_distance_of_neighbours": float(numpy.nanmin(gap)),
        "highest_pocket": float(numpy.nanmax(gap)),
        "sideways": sideways,
        "line_difference": line_difference,
        "line_places": met,
        "normal_jump": normal_jump(stack.top_face.Surface),
        "top_poles": [stack.top_face.Surface.NbUPoles, stack.top_face.Surface.NbVPoles],
        "all_valid": all(ply.face.isValid() for ply in stack.plies),
        "elapsed_ms": stack.report["elapsed_ms"],
    }


def draw(face, stack, path):
    """The section through the drop-off and the top surface's height over the skin."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot

    figure = pyplot.figure(figsize=(13, 9))
    section = figure.add_subplot(2, 1, 1)
    at = 560.0
    vs = numpy.linspace(DROP_OFF - 50, DROP_OFF + 15, 600)
    colours = pyplot.get_cmap("tab10")

    def height(surface, u, v):
        return (surface.value(u, v) - face.Surface.value(u, v)).dot(face.normalAt(u, v))

    for k, ply in enumerate(stack.plies):
        inside = [ply.base_face.isPartOfDomain(at, v) for v in vs]
        low = [height(ply.bottom_face.Surface, at, v) if ok else numpy.nan for v, ok in zip(vs, inside)]
        high = [height(ply.top_face.Surface, at, v) if ok else numpy.nan for v, ok in zip(vs, inside)]
        section.fill_between(vs, low, high, color=colours(k % 10), alpha=0.7, label=f"{ply.ply.name} {ROWS[k]}")
        section.plot(vs, high, color="black", linewidth=0.4)
    section.set_xlabel("along the span [mm]")
    section.set_ylabel("height over the skin [mm]")
    section.set_title(f"Section at u = {at:g}: five plies end 8 mm apart, ramps 1:20 (heights drawn 10 times larger)")
    section.set_aspect(10)
    section.legend(loc="upper right", fontsize=7)
    view = figure.add_subplot(2, 1, 2, projection="3d")
    u0, u1, v0, v1 = face.ParameterRange
    knots = lambda given, low, high: numpy.unique(
        numpy.concatenate([given, numpy.linspace(low, high, 25)])
    )  # noqa: E731
    us, vs = (
        knots(values, *ends)
        for values, ends in (
            (stack.top_face.Surface.getUKnots(), (u0, u1)),
            (stack.top_face.Surface.getVKnots(), (v0, v1)),
        )
    )
    grid = numpy.array(
        [[height(stack.top_face.Surface, u, v) if face.isPartOfDomain(u, v) else numpy.nan for v in vs] for u in us]
    )
    mesh_v, mesh_u = numpy.meshgrid(vs, us)
    view.plot_surface(
        mesh_v, mesh_u, grid, rcount=len(us), ccount=len(vs), cmap="viridis", linewidth=0, antialiased=False
    )
    view.set_xlabel("v (span)")
    view.set_ylabel("u (chord)")
    view.set_zlabel("height [mm]")
    view.set_title("Top of the stack over the skin")
    view.view_init(48, -75)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main() -> int:
    parser = argparse.ArgumentParser(description="A staggered drop-off and two patches on a wing skin.")
    parser.add_argument("--out", required=True, help="folder for the picture, the figures and the plies")
    parser.add_argument("--samples", type=int, default=1500, help="places in each part of the skin")
    parser.add_argument("--no-picture", action="store_true", help="only measure")
    given = parser.parse_args()
    os.makedirs(given.out, exist_ok=True)
    face = Part.read(SKIN).Faces[0]
    stack = lay(face)
    found = figures(face, stack, given.samples)
    print(json.dumps(found, indent=2))
    with open(os.path.join(given.out, "wing_drop_off.json"), "w", encoding="utf-8") as stream:
        json.dump(found, stream, indent=2)
    stack.to_shape().exportStep(os.path.join(given.out, "wing_drop_off.step"))
    if not given.no_picture:
        draw(face, stack, os.path.join(given.out, "wing_drop_off.png"))
    right = (
        found["largest_thickness_error"] <= 2 * TOLERANCE
        and found["least_distance_of_neighbours"] >= -2 * TOLERANCE
        and found["sideways"] <= TOLERANCE
        and found["line_difference"] <= TOLERANCE
        and found["normal_jump"] <= 1e-6
        and found["all_valid"]
    )
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
