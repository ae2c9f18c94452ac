# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks as files: what is written is read back.

FreeCAD 0.20 without its GUI crashes when it imports an assembly with names, its own ones too: tests/exchange reads names
and colours of STEP files part by part with OpenCASCADE, here their text is looked at.
"""

import base64
import csv
import io
import math
import os
import re
import zipfile
from html.parser import HTMLParser
from pathlib import Path
from typing import Any, Dict, List, Tuple
from xml.etree import ElementTree

import FreeCAD
import laminate_offset as lo
import numpy
import Part
import pytest
import sample_shapes
from conftest import PROJECT
from laminate_offset import cli, files
from laminate_offset.commands import plies
from laminate_offset.export import FORMATS
from laminate_offset.export.calculix import names
from laminate_offset.export.fibres import axes_of, fibre_directions
from laminate_offset.export.pictures import Mesh, view_of
from laminate_offset.ply_colours import angle_colour
from laminate_offset.replacing import FileError

Vector = FreeCAD.Vector


def small_stack(face: Any = None, **options: Any) -> lo.PlyStack:
    """Three plies with names that are hard to write."""
    plies = (
        lo.Ply("P1", "IM7-8552-134", angle=0.0),
        lo.Ply('Größe <2> & "more", end', "tape, thin", 0.2, 45.0),
        lo.Ply("P3", "EGlass-7781-Epoxy", angle=-30.0),
    )
    known = lo.materials()
    used = (known["IM7-8552-134"], known["EGlass-7781-Epoxy"])
    layup = lo.Layup(plies, used, **options)
    return lo.stack_plies(sample_shapes.trimmed_bspline_face() if face is None else face, layup)


@pytest.fixture(scope="module")
def stack() -> lo.PlyStack:
    return small_stack(sample_shapes.moved(sample_shapes.trimmed_bspline_face()))


def areas(stack: lo.PlyStack) -> List[float]:
    return [ply.face.Area for ply in stack.plies]


# STEP


class Step:
    """The entities of a STEP file, and who refers to whom."""

    def __init__(self, path: Path) -> None:
        self.text = path.read_text(encoding="utf-8")
        found = re.findall(r"^#(\d+)\s*=\s*(.*?);\s*$", self.text, re.MULTILINE | re.DOTALL)
        self.entities = {int(number): " ".join(content.split()) for number, content in found}

    def of(self, kind: str) -> Dict[int, str]:
        return {number: text for number, text in self.entities.items() if text.startswith(f"{kind}(")}

    def reached(self, start: int) -> List[int]:
        """Everything that an entity refers to, itself included."""
        seen, waiting = set(), [start]
        while waiting:
            number = waiting.pop()
            if number not in seen:
                seen.add(number)
                waiting += [int(other) for other in re.findall(r"#(\d+)", self.entities.get(number, ""))]
        return sorted(seen)

    def colours(self) -> List[Tuple[float, ...]]:
        """The colours of styled items, in the file's order."""
        found = []
        for item in self.of("STYLED_ITEM"):
            for number in self.reached(item):
                text = self.entities[number]
                if text.startswith("COLOUR_RGB"):
                    found.append(tuple(float(value) for value in re.findall(r"[-\d.E]+", text.split(",", 1)[1])))
        return found


@pytest.mark.parametrize("schema,mark", [("AP214", "AUTOMOTIVE_DESIGN"), ("AP242", "AP242_MANAGED_MODEL_BASED")])
def test_step_is_an_assembly_with_names_and_colours(stack: lo.PlyStack, schema: str, mark: str, tmp_path: Path) -> None:
    path = tmp_path / "stack.step"
    stack.export(str(path), schema=schema)
    step = Step(path)
    assert mark in step.text and "SI_UNIT(.MILLI.,.METRE.)" in step.text
    products = [re.findall(r"'((?:[^']|'')*)'", text)[0] for text in step.of("PRODUCT").values()]
    assert sorted(products) == sorted(["Stack of 3 plies, 0.584 mm"] + [ply.ply.name for ply in stack.plies])
    assert len(step.of("NEXT_ASSEMBLY_USAGE_OCCURRENCE")) == 3
    expected = sorted(angle_colour(ply.ply.ply.angle) for ply in stack.plies)
    assert numpy.array(sorted(set(step.colours()))) == pytest.approx(numpy.array(expected), abs=1e-6)
    for ply, face in zip(stack.plies, files.read_faces(str(path))):
        assert face.Area == pytest.approx(ply.face.Area, rel=1e-7)
        assert sample_shapes.deviation(ply.face, face, 0.0) < 1e-6
    assert os.listdir(tmp_path) == ["stack.step"]


def test_names_do_not_depend_on_what_freecad_wrote_before(stack: lo.PlyStack, tmp_path: Path) -> None:
    boxes = Part.Compound([Part.makeBox(1, 1, 1), Part.makeBox(3, 1, 1)])
    boxes.exportStep(str(tmp_path / "boxes.step"))
    before = len(Step(tmp_path / "boxes.step").of("NEXT_ASSEMBLY_USAGE_OCCURRENCE"))
    stack.export(str(tmp_path / "stack.step"))
    step = Step(tmp_path / "stack.step")
    assert len(step.of("PRODUCT")) == 4 and "translator" not in " ".join(step.of("PRODUCT").values())
    boxes.exportStep(str(tmp_path / "boxes.step"))
    assert len(Step(tmp_path / "boxes.step").of("NEXT_ASSEMBLY_USAGE_OCCURRENCE")) == before


def test_writing_does_not_change_the_plies(stack: lo.PlyStack, tmp_path: Path) -> None:
    before = [ply.face.exportBrepToString() for ply in stack.plies]
    for ending in (".step", ".FCStd", ".html"):
        stack.export(str(tmp_path / f"stack{ending}"))
    assert [ply.face.exportBrepToString() for ply in stack.plies] == before


# Documents and plain shapes


def test_a_document_holds_one_coloured_object_a_ply(stack: lo.PlyStack, tmp_path: Path) -> None:
    path = tmp_path / "stack.FCStd"
    stack.export(str(path))
    document = FreeCAD.openDocument(str(path), True)
    try:
        (container,) = [thing for thing in document.Objects if thing.TypeId == "App::Part"]
        assert container.Label == "Stack of 3 plies, 0.584 mm"
        plies = [thing for thing in container.Group if thing.TypeId == "Part::Feature"]
        assert [ply.Label for ply in plies] == [ply.ply.name for ply in stack.plies]
        assert [ply.Shape.Area for ply in plies] == pytest.approx(areas(stack), rel=1e-12)
        assert [ply.PlyMaterial for ply in plies] == ["IM7-8552-134", "tape, thin", "EGlass-7781-Epoxy"]
        assert [ply.FibreAngle.Value for ply in plies] == [0.0, 45.0, -30.0] and [ply.Number for ply in plies] == [
            1,
            2,
            3,
        ]
        for thing, ply in zip(plies, stack.plies):
            levels = [thing.Thickness.Value, thing.Bottom.Value, thing.Top.Value]
            assert levels == [ply.ply.thickness, ply.ply.bottom, ply.ply.top]
        assert all(ply.Visibility for ply in plies) and not container.Origin.Visibility
        object_names = [ply.Name for ply in plies]
    finally:
        FreeCAD.closeDocument(document.Name)
    with zipfile.ZipFile(path) as archive:
        views = ElementTree.fromstring(archive.read("GuiDocument.xml"))
    packed = {
        view.get("name"): int(colour.get("value"))
        for view in views.iter("ViewProvider")
        for colour in view.iter("PropertyColor")
    }
    assert list(packed) == object_names
    for name, ply in zip(object_names, stack.plies):
        colour = [packed[name] >> shift & 255 for shift in (24, 16, 8)]
        assert colour == [round(255 * part) for part in angle_colour(ply.ply.ply.angle)]
    assert [face.Area for face in files.read_faces(str(path))] == pytest.approx(areas(stack), rel=1e-12)


@pytest.mark.parametrize("ending", [".brep", ".BRP", ".iges", ".igs"])
def test_bare_shapes(stack: lo.PlyStack, ending: str, tmp_path: Path) -> None:
    path = str(tmp_path / f"stack{ending}")
    stack.export(path)
    assert [face.Area for face in files.read_faces(path)] == pytest.approx(areas(stack), rel=1e-7)


@pytest.mark.parametrize("ending", [".step", ".FCStd", ".brep"])
def test_solids(stack: lo.PlyStack, ending: str, tmp_path: Path) -> None:
    path = str(tmp_path / f"stack{ending}")
    stack.export(path, solids=True)
    if ending == ".FCStd":
        document = FreeCAD.openDocument(path, True)
        solids = [thing.Shape.copy() for thing in document.Objects if thing.TypeId == "Part::Feature"]
        FreeCAD.closeDocument(document.Name)
    else:
        shape = Part.Shape()
        shape.read(path)
        solids = shape.Solids
    assert len(solids) == 3 and all(solid.isValid() and solid.isClosed() for solid in solids)
    for solid, ply in zip(solids, stack.plies):
        assert solid.Volume == pytest.approx(ply.volume, rel=1e-2)
    if ending == ".step":
        step = Step(Path(path))
        assert len(step.of("MANIFOLD_SOLID_BREP")) == 3 and len(set(step.colours())) == 3


# Tables


def test_the_table_has_a_row_a_ply(stack: lo.PlyStack, tmp_path: Path) -> None:
    stack.export(str(tmp_path / "plies.csv"))
    with open(tmp_path / "plies.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["ply"] for row in rows] == [ply.ply.name for ply in stack.plies]
    for row, ply in zip(rows, stack.plies):
        assert (int(row["number"]), row["material"]) == (ply.ply.number, ply.ply.ply.material)
        for name in ("bottom", "middle", "top", "thickness"):
            assert float(row[f"{name}_mm"]) == getattr(ply.ply, name)
        assert float(row["angle_deg"]) == ply.ply.ply.angle
        assert float(row["area_mm2"]) == ply.area and float(row["volume_mm3"]) == ply.volume
        assert row["mass_kg"] == ("" if ply.mass is None else repr(ply.mass))
        assert float(row["certified_error_mm"]) == ply.report.certified_error <= 1e-3
        assert float(row["edge_error_mm"]) == ply.report.edge_error


# Ply book


class Book(HTMLParser):
    """The ply book's pictures, links, texts by element, and open elements at the end."""

    EMPTY = {"meta", "img"}

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.open: List[str] = []
        self.images: List[Dict[str, str]] = []
        self.links: List[str] = []
        self.identities: List[str] = []
        self.texts: Dict[str, List[str]] = {}
        self.feed(path.read_text(encoding="utf-8"))
        self.close()

    def handle_starttag(self, tag: str, pairs: Any) -> None:
        attributes = dict(pairs)
        self.identities += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes["href"]] if "href" in attributes else []
        if tag == "img":
            self.images.append(attributes)
        if tag not in self.EMPTY:
            self.open.append(tag)
            self.texts.setdefault(tag, []).append("")

    def handle_endtag(self, tag: str) -> None:
        if tag not in self.EMPTY:
            assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        for tag in set(self.open):
            self.texts[tag][-1] += data


def test_the_ply_book_is_whole(stack: lo.PlyStack, tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image", reason="Pillow is not installed")
    path = tmp_path / "book.html"
    seen: List[float] = []
    lo.export_ply_book(stack, str(path), "Skin <left>", progress=seen.append)
    book = Book(path)
    assert book.open == [] and book.texts["h1"] == ["Skin <left>"] and seen == [0.0, 1.0 / 3.0, 2.0 / 3.0]
    assert book.identities == ["cover", "ply1", "ply2", "ply3"]
    assert all(link[0] == "#" and link[1:] in book.identities for link in book.links)
    assert len(book.images) == 1 + len(stack.plies)
    content = path.read_text(encoding="utf-8")
    assert not re.search(r"https?:|<script|<link", content), "the file needs another one"
    cells = book.texts["td"]
    for ply in stack.plies:
        title = f"Ply {ply.ply.number}: {ply.ply.name}"
        assert title in book.texts["h2"] and ply.ply.name in cells and ply.ply.ply.material in cells
        assert f"{ply.ply.ply.angle:g}\N{DEGREE SIGN}" in cells
        assert ply.mass is None or f"{ply.mass:.4g} kg" in cells
    assert any("[0/45/-30]" in cell for cell in cells)
    for number, attributes in enumerate(book.images):
        png = base64.b64decode(attributes["src"].split("base64,")[1])
        picture = numpy.asarray(image.open(io.BytesIO(png)).convert("RGB")).reshape(-1, 3)
        assert attributes["alt"] and len(picture) > 10**5
        if number:  # the ply's own colour, shaded, fills a good part of its picture
            colour = 0.35 + 0.65 * numpy.array(angle_colour(stack.plies[number - 1].ply.ply.angle))
            ratio = picture / (255.0 * colour)
            shaded = (numpy.ptp(ratio, axis=1) < 0.03) & (ratio.max(axis=1) < 1.0) & (ratio.min(axis=1) > 0.2)
            assert shaded.mean() > 0.15


def test_the_ply_book_can_be_stopped(stack: lo.PlyStack, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        lo.export_ply_book(stack, str(tmp_path / "book.html"), progress=lambda fraction: False)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(
    "face", [sample_shapes.cylinder_face(), sample_shapes.sphere_face(), sample_shapes.plane_face()]
)
def test_faces_of_other_kinds_have_pictures(face: Any, tmp_path: Path) -> None:
    small_stack(face).export(str(tmp_path / "book.html"))
    assert len(Book(tmp_path / "book.html").images) == 4


@pytest.mark.parametrize("turn", [lambda face: face, sample_shapes.reversed_face])
def test_the_picture_looks_at_the_outer_side(turn: Any) -> None:
    stack = small_stack(turn(sample_shapes.trimmed_bspline_face()))
    view = view_of(stack)
    face = stack.bottom_face
    u, v = 0.5 * sum(face.ParameterRange[:2]), 0.5 * sum(face.ParameterRange[2:])
    assert Vector(*view.towards) * face.normalAt(u, v) > 0.9
    mesh = Mesh(face, 0.1)
    assert (mesh.normals @ view.towards).min() > 0.5
    assert mesh.areas.sum() == pytest.approx(face.Area, rel=1e-3)
    assert view.right @ view.axes.first > 0.9 and view.up @ view.axes.second > 0.9


def test_fibres_run_at_their_angle_in_the_surface() -> None:
    stack = small_stack(sample_shapes.sphere_face())
    axes = axes_of(stack)
    rng = numpy.random.default_rng(7)
    normals = rng.normal(size=(200, 3))
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    first = fibre_directions(axes, normals, 0.0)
    for angle in (-45.0, 0.0, 30.0, 90.0, 180.0):
        directions = fibre_directions(axes, normals, angle)
        assert numpy.abs(numpy.sum(directions * normals, axis=1)).max() < 1e-12
        assert numpy.abs(numpy.linalg.norm(directions, axis=1) - 1.0).max() < 1e-12
        cosines, sines = numpy.sum(first * directions, axis=1), numpy.cross(first, directions)
        assert numpy.abs(cosines - math.cos(math.radians(angle))).max() < 1e-12
        assert numpy.abs(numpy.sum(sines * normals, axis=1) - math.sin(math.radians(angle))).max() < 1e-12
    assert numpy.all(fibre_directions(axes, axes.first[None, :], 45.0) == 0.0)


# CalculiX


def sections(path: Path) -> Tuple[Dict[str, numpy.ndarray], Dict[str, str], List[Tuple[float, str, str]]]:
    """Orientations by name, the parameters of the section, and its layers."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("**")]
    orientations, parameters, layers = {}, {}, []
    keyword: List[str] = []
    for line in lines:
        cells = [cell.strip() for cell in line.split(",")]
        if line.startswith("*"):
            keyword = cells
            if keyword[0] == "*SHELL SECTION":
                assert keyword[1] == "COMPOSITE"
                parameters = dict(cell.split("=") for cell in keyword[2:])
        elif keyword[0] == "*ORIENTATION":
            assert keyword[2] == "SYSTEM=RECTANGULAR" and all(len(cell) <= 20 for cell in cells)
            orientations[keyword[1].split("=")[1]] = numpy.array([float(cell) for cell in cells]).reshape(2, 3)
        else:
            assert len(cells) == 4 and cells[1] == "" and len(cells[0]) <= 20
            layers.append((float(cells[0]), cells[2], cells[3]))
    return orientations, parameters, layers


@pytest.mark.parametrize(
    "direction,reference,offset",
    [("normal", "tool", -0.5), ("normal", "middle", 0.0), ("normal", "top", 0.5), ("reversed", "tool", 0.5)],
)
def test_calculix_has_the_layers_along_the_normal(
    direction: str, reference: str, offset: float, tmp_path: Path
) -> None:
    stack = small_stack(direction=direction, reference=reference)
    stack.export(str(tmp_path / "section.inp"))
    orientations, parameters, layers = sections(tmp_path / "section.inp")
    assert parameters["ELSET"] == "EPLIES" and float(parameters["OFFSET"]) == pytest.approx(offset, abs=1e-12)
    plies = [ply.ply for ply in stack.plies]
    if direction == "reversed":
        plies.reverse()
    assert [layer[0] for layer in layers] == [ply.thickness for ply in plies]
    assert {layer[1] for layer in layers} == {"IM7-8552-134", "TAPE__THIN", "EGLASS-7781-EPOXY"}
    axes = axes_of(stack)
    for ply, (_, _, name) in zip(plies, layers):
        first, second = orientations[name]
        expected = fibre_directions(axes, axes.normal[None, :], ply.ply.angle)[0]
        assert first == pytest.approx(expected, abs=1e-9)
        assert numpy.cross(first, second) == pytest.approx(axes.normal, abs=1e-9)
    text = (tmp_path / "section.inp").read_text(encoding="utf-8")
    assert "*MATERIAL, NAME=IM7-8552-134, *DENSITY 1.57e-09 t/mm3" in text
    assert max(map(len, text.splitlines())) <= 132


def test_a_rosette_sets_the_axes(tmp_path: Path) -> None:
    stack = small_stack()
    corner = stack.base_face.valueAt(0.1, 0.1)
    rosette = lo.Rosette(tuple(corner), (0.3, 1.0, 0.2))
    lo.export_calculix(stack, str(tmp_path / "section.inp"), rosette=rosette)
    orientations, _, layers = sections(tmp_path / "section.inp")
    for ply, (_, _, name) in zip(stack.plies, layers):
        assert orientations[name][0] == pytest.approx(stack.fibre_directions(ply, [[0.1, 0.1]], rosette)[0], abs=1e-7)
    axes = view_of(stack, rosette).axes
    places = numpy.random.default_rng(5).uniform(0.05, 0.95, (50, 2))
    normals = numpy.array([tuple(stack.base_face.normalAt(u, v)) for u, v in places])
    for ply in stack.plies:
        expected = stack.fibre_directions(ply, places, rosette)
        assert numpy.abs(fibre_directions(axes, normals, ply.ply.ply.angle) - expected).max() < 1e-7
    lo.export_ply_book(stack, str(tmp_path / "book.html"), rosette=rosette)


def test_calculix_names_differ_and_are_plain(tmp_path: Path) -> None:
    texts = ["a b", "a_b", "A-B", "ä" * 200, "ä" * 200 + "b", "x"]
    found = names(texts)
    assert len(set(found.values())) == len(texts)
    assert all(re.fullmatch(r"[A-Z0-9_-]{1,80}", name) for name in found.values())
    stack = small_stack()
    lo.export_calculix(stack, str(tmp_path / "a.inp"), "skin")
    assert "ELSET=SKIN," in (tmp_path / "a.inp").read_text()
    for wrong in ("", "a b", "x" * 100):
        with pytest.raises(ValueError, match="element_set"):
            lo.export_calculix(stack, str(tmp_path / "b.inp"), wrong)


# Plies on parts of the face


@pytest.fixture(scope="module")
def partial() -> lo.PlyStack:
    """A ply on a disc between two on the whole face."""
    plies = [lo.Ply("P1", "tape", 0.2), lo.Ply("patch", "tape", 0.2, 45.0, boundary="disc"), lo.Ply("P3", "tape", 0.2)]
    disc = Part.Wire(Part.makeCircle(20.0, Vector(50.0, 50.0, 0.0)))
    return lo.stack_plies(sample_shapes.bspline_face(), lo.Layup(plies), boundaries={"disc": disc})


def test_partial_plies_are_written(partial: lo.PlyStack, tmp_path: Path) -> None:
    for ending in (".step", ".FCStd", ".brep"):
        path = str(tmp_path / f"stack{ending}")
        partial.export(path)
        assert [face.Area for face in files.read_faces(path)] == pytest.approx(areas(partial), rel=1e-6)
    partial.export(str(tmp_path / "solids.step"), solids=True)
    assert len(Step(tmp_path / "solids.step").of("MANIFOLD_SOLID_BREP")) == 3
    partial.export(str(tmp_path / "plies.csv"))
    with open(tmp_path / "plies.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["over_ramp"] for row in rows] == ["no", "no", "yes"]
    assert [row["boundary"] for row in rows] == ["", "disc", ""] and not any(row["mass_kg"] for row in rows)
    figures = partial.mass_properties().plies
    assert [float(row["volume_mm3"]) for row in rows] == [figure.volume for figure in figures]
    partial.export(str(tmp_path / "book.html"))
    book = Book(tmp_path / "book.html")
    assert len(book.images) == 4 and "disc" in book.texts["td"] and "the whole face" in book.texts["td"]
    with pytest.raises(ValueError, match="patch cover parts of the face only"):
        partial.export(str(tmp_path / "section.inp"))
    assert not (tmp_path / "section.inp").exists()


# All of them


def test_angles_do_not_count_from_other_axes_than_the_rows_name(tmp_path: Path) -> None:
    layup = lo.Layup((lo.Ply("P1", "tape", 0.2, 45.0, rosette="nose"),))
    stack = lo.stack_plies(sample_shapes.bspline_face(), layup)
    for write, name in ((lo.export_calculix, "a.inp"), (lo.export_ply_book, "a.html")):
        with pytest.raises(ValueError, match="the rosette 'nose', which is not known.*rosette="):
            write(stack, str(tmp_path / name))
        write(stack, str(tmp_path / name), rosette=lo.Rosette((0, 0, 0), (1, 0, 0)))
        assert (tmp_path / name).exists()


def test_plies_of_several_rosettes_are_not_drawn_with_one(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    plies = (lo.Ply("P1", "tape", 0.2, rosette="nose"), lo.Ply("P2", "tape", 0.2, rosette="tail"))
    mixed = lo.stack_plies(sample_shapes.bspline_face(), lo.Layup(plies))
    for write, name in ((lo.export_calculix, "section.inp"), (lo.export_ply_book, "book.html")):
        with pytest.raises(ValueError, match="different rosettes .'nose', 'tail'.*plies of one rosette only"):
            write(mixed, str(tmp_path / name), rosette=lo.Rosette((0, 0, 0), (1, 0, 0)))
    source, table, output = tmp_path / "base.brep", tmp_path / "layup.csv", tmp_path / "plies.step"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    mixed.layup.write(str(table))
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(output)]
    for option, name in (("--calculix", "section.inp"), ("--book", "book.html")):
        assert cli.main([*arguments, option, str(tmp_path / name)]) == 2
        assert "different rosettes" in capfd.readouterr().err
    assert sorted(os.listdir(tmp_path)) == ["base.brep", "layup.csv"]


@pytest.mark.parametrize(
    "text,told",
    [
        ("0,0,0", "origin and first axis must stand on either side of one colon; write [NAME=]X,Y,Z:DX,DY,DZ"),
        ("0,0,0:1,0,0:2", "either side of one colon"),
        (
            "0,0:1,0,0",
            "'0,0' is not three numbers with commas between; write [NAME=]X,Y,Z:DX,DY,DZ, with lengths in mm",
        ),
        ("0,0,0:1,0,0,0", "'1,0,0,0' is not three numbers"),
        ("nose=0,x,0:1,0,0", "'0,x,0' is not three numbers"),
        ("=0,0,0:1,0,0", "a name must stand before ="),
        ("0,0,0:0,0,0", "direction must not be zero"),
        ("0,0,inf:1,0,0", "origin must be three finite numbers"),
    ],
)
def test_wrong_rosettes_of_the_command_are_told(text: str, told: str, capfd: pytest.CaptureFixture[str]) -> None:
    arguments = ["plies", "base.brep", "--face", "1", "--layup", "layup.csv", "-o", "plies.step", "--rosette", text]
    with pytest.raises(SystemExit) as ended:
        cli.main(arguments)
    printed = capfd.readouterr().err
    assert ended.value.code == 2 and told in printed, printed
    assert "could not convert" not in printed and "unpack" not in printed


@pytest.mark.parametrize("error,code", [(KeyboardInterrupt(), 130), (FileError("the disk is full"), 2)])
def test_what_ends_the_last_file_leaves_none(
    error: BaseException, code: int, tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def ended(*_arguments: Any, **_options: Any) -> None:
        assert len(list(tmp_path.glob(".laminate-offset-*/plies.step"))) == 1, "the first file is not yet made"
        raise error

    monkeypatch.setattr(plies, "export_calculix", ended)
    source, table = tmp_path / "base.brep", tmp_path / "layup.csv"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\n", encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
    assert cli.main([*arguments, "--calculix", str(tmp_path / "section.inp")]) == code
    assert "wrote" not in capfd.readouterr().err and sorted(os.listdir(tmp_path)) == ["base.brep", "layup.csv"]


def test_a_rosette_that_no_file_needs_is_told(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table = tmp_path / "base.brep", tmp_path / "layup.csv"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\n", encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
    arguments += ["--table", str(tmp_path / "plies.csv"), "--rosette", "0,0,0:1,0,0"]
    assert cli.main(arguments) == 2
    assert "--rosette: no file that is asked for has angles from a rosette; give --book" in capfd.readouterr().err
    assert sorted(os.listdir(tmp_path)) == ["base.brep", "layup.csv"]
    assert cli.main([*arguments, "--calculix", str(tmp_path / "section.inp")]) == 0


@pytest.mark.parametrize("values", ["abc", 5, (1, 2), (1, 2, "x"), (1, 2, float("nan"))])
def test_a_rosette_has_two_times_three_numbers(values: Any) -> None:
    with pytest.raises(ValueError, match="origin must be three finite numbers x, y, z; it is"):
        lo.Rosette(values, (1, 0, 0))
    with pytest.raises(ValueError, match="direction must be three finite numbers x, y, z; it is"):
        lo.Rosette((0, 0, 0), values)


def test_what_cannot_be_written_says_why(stack: lo.PlyStack, tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"stack.dwg: '.dwg' is not a known format of stacks; use one of .step"):
        stack.export(str(tmp_path / "stack.dwg"))
    with pytest.raises(ValueError, match="schema must be one of AP214, AP242; it is 'AP203'"):
        stack.export(str(tmp_path / "stack.step"), schema="AP203")
    for ending in FORMATS:
        with pytest.raises(FileError, match="cannot be written"):
            stack.export(f"/proc/stack{ending}")
    assert os.listdir(tmp_path) == []


def test_the_ply_book_without_matplotlib(python, tmp_path: Path) -> None:
    code = (
        "import sys; sys.modules['matplotlib.figure'] = None; sys.modules['matplotlib'] = None\n"
        "import laminate_offset as lo, Part\n"
        "from laminate_offset.replacing import FileError\n"
        "stack = lo.stack_plies(Part.makePlane(9, 9).Faces[0], lo.layup_from_notation('[0]', 'IM7-8552-134'))\n"
        "try:\n"
        f"    stack.export({str(tmp_path / 'book.html')!r})\n"
        "except FileError as error:\n"
        "    print(error)\n"
    )
    run = python(code)
    assert "need Matplotlib (on Debian: apt-get install python3-matplotlib)" in run.stdout, run.stderr


def test_the_command_writes_all_of_them(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table = tmp_path / "base.brep", tmp_path / "layup.csv"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\nP2,tape,0.3,90\n", encoding="utf-8")
    outputs = {name: tmp_path / name for name in ("plies.step", "book.html", "plies.csv", "section.inp")}
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(outputs["plies.step"])]
    arguments += ["--schema", "AP242", "--book", str(outputs["book.html"]), "--table", str(outputs["plies.csv"])]
    assert cli.main(arguments + ["--calculix", str(outputs["section.inp"])]) == 0
    written = capfd.readouterr().err
    assert all(f"wrote {path}" in written for path in outputs.values())
    assert "AP242" in outputs["plies.step"].read_text() and len(Book(outputs["book.html"]).images) == 3
    assert len(sections(outputs["section.inp"])[2]) == 2 and outputs["plies.csv"].read_text().count("\n") == 3
    assert cli.main(arguments[:8] + ["--table", str(table)]) == 2
    assert "layup.csv: is the input" in capfd.readouterr().err
    assert cli.main(arguments + ["--table", str(outputs["plies.csv"]), "--report", str(outputs["plies.csv"])]) == 2
    assert "give it a name of its own" in capfd.readouterr().err
    for option in ("--book", "--table", "--calculix"):
        assert cli.main(arguments[:8] + [option, str(tmp_path / "a.txt")]) == 2
        assert f"{option}: " in capfd.readouterr().err


def test_the_documentation_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (PROJECT / "docs" / "exports.md").read_text(encoding="utf-8")
    (tmp_path / "resources").symlink_to(PROJECT / "resources")
    monkeypatch.chdir(tmp_path)
    (example,) = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    exec(compile(example, "exports.md", "exec"), {})
    written = ["book.html", "layup.h5", "plies.FCStd", "plies.csv", "plies.step", "section.inp"]
    assert sorted(os.listdir(tmp_path)) == sorted([*written, "resources"])
    assert all(f"`{ending}`" in text for ending in FORMATS if ending not in (".fcstd", ".htm")) and "`.FCStd`" in text
