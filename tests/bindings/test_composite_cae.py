# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups in the layout HDF5 composite CAE: the file is read back with h5py and held against the stack and FreeCAD."""

import fnmatch
import json
import os
import re
from pathlib import Path
from typing import Any, Dict, List, Tuple

import FreeCAD
import h5py
import laminate_offset as lo
import numpy
import Part
import pytest
import sample_shapes
from laminate_offset import cli, files
from laminate_offset.export.triangles import with_short_sides
from laminate_offset.replacing import FileError

Vector = FreeCAD.Vector


def layup(**options: Any) -> lo.Layup:
    plies = (
        lo.Ply("P1", "IM7-8552-134", angle=0.0),
        lo.Ply('Größe <2> & "more", end', "tape, thin", 0.2, 45.0),
        lo.Ply("P3", "IM7-8552-134", angle=-30.0),
    )
    return lo.Layup(plies, (lo.materials()["IM7-8552-134"],), **options)


def text(node: Any, name: str = "title") -> str:
    return bytes(node.attrs[name]).decode("utf-8")


class Read:
    """The components of a file in the order of their layers; arrays as NumPy has them."""

    def __init__(self, path: Path) -> None:
        with h5py.File(path, "r") as file:
            self.root = file["composite_cae"]
            names = (
                "format_version",
                "last_modified",
                "vendor",
                "unit_system",
                "length_unit",
                "unconfirmed_names",
                "guessed_meanings",
            )
            self.attributes = {name: text(self.root, name) for name in names}
            components = sorted(self.root["components"].values(), key=lambda node: node.attrs["layer_id"][0])
            self.plies = [self._component(node) for node in components]
            self.meshes = {key: self._mesh(node) for key, node in self.root["meshes"].items()}
            self.fabrics = [text(node) for node in self.root["material_data/fabrics"].values()]
            self.names: List[str] = []
            self.attribute_names: List[str] = []
            self._walk("", self.root)

    @classmethod
    def of(cls, stack: lo.PlyStack, folder: Path) -> "Read":
        stack.export(str(folder / "read.h5"))
        return cls(folder / "read.h5")

    @staticmethod
    def _mesh(node: Any) -> Tuple[Any, Any]:
        return node["nodes"][:], node["element_nodes"][:]

    def _component(self, node: Any) -> Dict[str, Any]:
        data = node["data_map"]
        assert text(node) == text(node, "TITLE")
        return {
            "layer": node.attrs["layer_id"][0],
            "angle": node.attrs["orientation"][0],
            "title": text(node),
            "material": text(node["material"]),
            "rosettes": [text(rosette) for rosette in node["rosettes"].values()],
            "nodes": node["mesh/nodes"][:],
            "elements": node["mesh/element_nodes"][:],
            "mesh": node.get("mesh", getlink=True).path,
            "thicknesses": data["thicknesses"][:],
            "angles": data["matorient_0_angles"][:],
            "reference": data["reference_directions"][:],
            "fibres": data["fiber_directions"][:],
        }

    def _walk(self, place: str, group: Any) -> None:
        """All paths below a group, links followed."""
        for name, node in group.items():
            path = f"{place}/{name}".strip("/")
            self.names.append(path)
            self.attribute_names += [f"{path}.{attribute}" for attribute in node.attrs]
            if isinstance(node, h5py.Group):
                self._walk(path, node)


def corners(ply: Dict[str, Any]) -> Any:
    return ply["nodes"][ply["elements"]]


def twice_areas(points: Any) -> Any:
    return numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])


def normals_at(face: Any, points: Any) -> Any:
    """The outward normals by FreeCAD at the points of a surface nearest to some others."""
    places = [face.Surface.parameter(Vector(*point)) for point in points]
    return numpy.array([tuple(face.normalAt(u, v)) for u, v in places])


def check_elements(stack: lo.PlyStack, ply: lo.StackPly, read: Dict[str, Any], size: float) -> Tuple[Any, Any]:
    """The mesh covers the ply's part and nothing else. Returns some of the elements, and the outward normals by FreeCAD
    there."""
    sign = -1.0 if stack.report["direction"] == "reversed" else 1.0
    points = corners(read)
    crossed = twice_areas(points)
    assert len(points) == len(read["elements"]) > 10 and sorted(set(read["elements"].ravel())) == list(
        range(len(read["nodes"]))
    )
    assert 0.5 * numpy.linalg.norm(crossed, axis=1).sum() == pytest.approx(ply.base_face.Area, rel=5e-3)
    sides = numpy.linalg.norm(points - numpy.roll(points, 1, axis=1), axis=2)
    assert 0.1 * size < sides.max() <= size
    rows = numpy.unique(numpy.linspace(0, len(points) - 1, 150).astype(int))
    normals = normals_at(stack.base_face, points[rows].mean(axis=1))
    assert (sign * crossed[rows] * normals).sum(axis=1).min() > 0.0
    assert lo.nearest_point(ply.base_face, read["nodes"], trimmed=True).distance.max() < 1e-9
    # OpenCASCADE is less exact, and measures to edges that keep within the tolerance
    exact = 1e-3 if ply.ply.ply.boundary else 1e-5
    for point in read["nodes"][:: len(read["nodes"]) // 5]:
        assert ply.base_face.distToShape(Part.Vertex(Vector(*point)))[0] < exact
    return rows, normals


def check_directions(ply: lo.StackPly, read: Dict[str, Any], checked: Tuple[Any, Any], first: Any, sign: float) -> None:
    """checked: elements, and the normals there. first: the first axis where the rosette stands."""
    rows, normals = checked
    count = len(read["elements"])
    assert read["reference"].shape == read["fibres"].shape == (count, 3)
    assert numpy.all(read["thicknesses"] == ply.ply.thickness) and len(read["thicknesses"]) == count
    assert numpy.all(read["angles"] == read["angle"]) and len(read["angles"]) == count
    assert read["angle"] == sign * ply.ply.ply.angle
    expected = first - (normals @ first)[:, None] * normals
    expected /= numpy.linalg.norm(expected, axis=1)[:, None]
    reference, fibres = read["reference"][rows], read["fibres"][rows]
    assert numpy.abs(reference - expected).max() < 1e-6
    for directions in (read["reference"], read["fibres"]):
        assert numpy.abs(numpy.linalg.norm(directions, axis=1) - 1.0).max() < 1e-12
    for directions in (reference, fibres):
        assert numpy.abs((directions * normals).sum(axis=1)).max() < 1e-6
    # counted about the side on which plies are laid
    about = sign * normals
    cosine = (reference * fibres).sum(axis=1)
    sine = (numpy.cross(reference, fibres) * about).sum(axis=1)
    turned = numpy.radians(read["angles"][rows])
    assert numpy.abs(cosine - numpy.cos(turned)).max() < 1e-6 and numpy.abs(sine - numpy.sin(turned)).max() < 1e-6


@pytest.mark.parametrize("direction", ["normal", "reversed"])
@pytest.mark.parametrize("turn", [lambda face: face, sample_shapes.reversed_face])
def test_every_ply_is_read_back(direction: str, turn: Any, tmp_path: Path) -> None:
    face = turn(sample_shapes.moved(sample_shapes.trimmed_bspline_face()))
    stack = lo.stack_plies(face, layup(direction=direction))
    middle = face.valueAt(*(0.5 * sum(face.ParameterRange[2 * k : 2 * k + 2]) for k in range(2)))
    rosette = lo.Rosette(tuple(middle), (0.2, 1.0, 0.3))
    size = face.BoundBox.DiagonalLength / 15.0
    lo.export_composite_cae(stack, str(tmp_path / "layup.h5"), size, rosette)
    read = Read(tmp_path / "layup.h5")
    sign = -1.0 if direction == "reversed" else 1.0
    assert [(ply["layer"], ply["title"]) for ply in read.plies] == [
        (k + 1, p.ply.name) for k, p in enumerate(stack.plies)
    ]
    assert [ply["material"] for ply in read.plies] == ["IM7-8552-134", "tape, thin", "IM7-8552-134"]
    assert read.fabrics == ["IM7-8552-134", "tape, thin"]
    assert len(read.meshes) == 1 and all(ply["rosettes"] == ["Rosette"] for ply in read.plies)
    at = normals_at(face, [middle])[0]
    first = numpy.array(rosette.direction) - (at @ rosette.direction) * at
    checked = check_elements(stack, stack.plies[0], read.plies[0], size)
    for ply, found in zip(stack.plies, read.plies):
        check_directions(ply, found, checked, first, sign)
    assert len({round(ply["angle"], 6) for ply in read.plies}) == 3
    assert os.listdir(tmp_path) == ["layup.h5"]


def test_units_and_names(tmp_path: Path) -> None:
    stack = lo.stack_plies(sample_shapes.bspline_face(), layup())
    stack.export(str(tmp_path / "layup.hdf5"))
    read = Read(tmp_path / "layup.hdf5")
    assert read.attributes["format_version"] == "1.0" and read.attributes["unit_system"] == "SI"
    assert read.attributes["length_unit"] == "mm" and read.attributes["vendor"].startswith("LaminateOffset ")
    assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\dZ", read.attributes["last_modified"])
    assert all(re.fullmatch("[a-zA-Z_][a-zA-Z0-9_]*", name) for path in read.names for name in path.split("/"))
    # each name that the file calls unconfirmed is there, and every component has it
    for pattern in read.attributes["unconfirmed_names"].split():
        found = fnmatch.filter(read.attribute_names if "." in pattern else read.names, pattern)
        assert len(found) == (3 if pattern.startswith("components") else 1), pattern
    for pattern in read.attributes["guessed_meanings"].split():
        assert fnmatch.filter(read.attribute_names if "." in pattern else read.names, pattern), pattern
    with h5py.File(tmp_path / "layup.hdf5", "r") as file:
        one, other = (file[f"composite_cae/components/component_{k}/data_map/reference_directions"] for k in (1, 3))
        assert one == other, "the same numbers are stored twice"


def test_plies_on_parts_have_elements_there_only(tmp_path: Path) -> None:
    plies = [lo.Ply("P1", "tape", 0.2), lo.Ply("patch", "tape", 0.3, 45.0, boundary="disc"), lo.Ply("P3", "tape", 0.2)]
    disc = Part.Wire(Part.makeCircle(20.0, Vector(50.0, 50.0, 0.0)))
    stack = lo.stack_plies(sample_shapes.bspline_face(), lo.Layup(plies), boundaries={"disc": disc})
    lo.export_composite_cae(stack, str(tmp_path / "layup.h5"), FreeCAD.Units.Quantity("4 mm"))
    read = Read(tmp_path / "layup.h5")
    assert len(read.meshes) == 2 and read.plies[0]["mesh"] == read.plies[2]["mesh"] != read.plies[1]["mesh"]
    whole, patch = len(read.plies[0]["elements"]), len(read.plies[1]["elements"])
    assert 50 < patch < 0.3 * whole
    for ply, found in zip(stack.plies, read.plies):
        check_elements(stack, ply, found, 4.0)
        middles = corners(found).mean(axis=1)
        uv = lo.nearest_point(stack.base_face, middles).uv
        bottom, top = ply.levels(uv)
        assert numpy.abs(top - bottom - found["thicknesses"]).max() < 2e-3  # NaN where the ply is not
    assert away(read.plies[1]["nodes"]) < 20.5 and away(read.plies[0]["nodes"]) > 45.0


def away(points: Any) -> float:
    return float(numpy.linalg.norm(points[:, :2] - (50.0, 50.0), axis=1).max())


@pytest.mark.parametrize(
    "face",
    [sample_shapes.cylinder_face(), sample_shapes.sphere_face(), sample_shapes.plane_face(), Part.makeTorus(50, 9)],
)
def test_faces_of_other_kinds(face: Any, tmp_path: Path) -> None:
    face = face.Faces[0]
    stack = lo.stack_plies(face, layup())
    size = 0.1 * face.BoundBox.DiagonalLength
    lo.export_composite_cae(stack, str(tmp_path / "layup.h5"), size, lo.Rosette((1, 2, 3), (0.3, 0.4, 0.5)))
    (found,) = {ply["mesh"]: ply for ply in Read(tmp_path / "layup.h5").plies}.values()
    check_elements(stack, stack.plies[0], found, size)
    check_sides(found["elements"])
    if face.isClosed():
        assert border(found["elements"]) == 0


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 0, 0), (0, 1, 0)])
def test_a_whole_tube_has_axes_of_its_own_accord(axis: Tuple[int, int, int], tmp_path: Path) -> None:
    tube = Part.makeCylinder(30.0, 200.0, Vector(1, 2, 3), Vector(*axis)).Faces[0]
    stack = lo.stack_plies(tube, layup())
    stack.export(str(tmp_path / "layup.h5"))
    (found,) = {ply["mesh"]: ply for ply in Read(tmp_path / "layup.h5").plies[:1]}.values()
    assert numpy.abs(found["reference"] - numpy.array(axis)).max() < 1e-9, "x and y stand on a tube round the other one"
    plate = Read.of(lo.stack_plies(sample_shapes.bspline_face(), layup()), tmp_path)
    assert plate.plies[0]["reference"][:, 0].min() > 0.7, "x where it stands nowhere"


def check_sides(triangles: Any) -> None:
    """Neighbours share their corners and run round them in the same sense."""
    sides = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    assert len(numpy.unique(sides, axis=0)) == len(sides)


def border(triangles: Any) -> int:
    sides = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return int((numpy.unique(numpy.sort(sides, axis=1), axis=0, return_counts=True)[1] == 1).sum())


def test_halved_sides_keep_the_area_and_the_neighbours() -> None:
    rng = numpy.random.default_rng(3)
    points = numpy.column_stack([rng.uniform(-9.0, 9.0, (4, 2)), numpy.zeros(4)])
    points[:, :2] += [(0, 0), (40, 0), (40, 20), (0, 20)]
    triangles = numpy.array([(0, 1, 2), (0, 2, 3)])
    for longest in (100.0, 30.0, 11.0, 2.0, 0.7):
        finer, cut = with_short_sides(points, triangles, longest, lambda middles: middles)
        signed = twice_areas(finer[cut])[:, 2]
        assert signed.min() > 0.0 and signed.sum() == pytest.approx(
            twice_areas(points[triangles])[:, 2].sum(), rel=1e-12
        )
        sides = finer[cut] - numpy.roll(finer[cut], 1, axis=1)
        assert numpy.linalg.norm(sides, axis=2).max() <= longest
        check_sides(cut)
        assert len(finer) - (3 * len(cut) + border(cut)) // 2 + len(cut) == 1, "a corner lies inside of a side"
    assert len(cut) > 1000


def test_plies_of_several_rosettes(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    plies = (lo.Ply("P1", "tape", 0.2, rosette="nose"), lo.Ply("P2", "tape", 0.2, 30.0, rosette="tail"))
    stack = lo.stack_plies(sample_shapes.bspline_face(), lo.Layup(plies))
    axes = {"nose": lo.Rosette((0, 0, 0), (1, 0, 0)), "tail": lo.Rosette((9, 9, 9), (0, 1, 0))}
    path = tmp_path / "layup.h5"
    for wrong in (None, axes["nose"]):
        with pytest.raises(ValueError, match="different rosettes .'nose', 'tail'"):
            lo.export_composite_cae(stack, str(path), rosette=wrong)
    with pytest.raises(ValueError, match="rosette has no rosette 'tail'"):
        lo.export_composite_cae(stack, str(path), rosette={"nose": axes["nose"]})
    lo.export_composite_cae(stack, str(path), rosette=axes)
    read = Read(path)
    assert [ply["rosettes"] for ply in read.plies] == [["nose"], ["tail"]]
    for ply, found in zip(stack.plies, read.plies):
        uv = lo.nearest_point(stack.base_face, corners(found).mean(axis=1)).uv
        assert numpy.abs(stack.fibre_directions(ply, uv, axes) - found["fibres"]).max() < 1e-9
    source, table = tmp_path / "base.brep", tmp_path / "layup.csv"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    stack.layup.write(str(table))
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
    to_h5 = [*arguments, "--hdf5", str(tmp_path / "other.hdf5")]
    nose, tail = ["--rosette", "nose=0,0,0:1,0,0"], ["--rosette", "tail=9,9,9:0,1,0"]
    for given, reason in (
        ([], "different rosettes .*give all of them with --rosette"),
        (nose, "there is none for the rows that name 'tail'; give all of them"),
        ([*nose, *tail, *tail], "tail is given twice"),
        (
            [*nose, *tail, "--rosette", "fin=0,0,0:1,0,0"],
            "no row of the layup names 'fin'; the rows name 'nose', 'tail'",
        ),
        ([*nose, *tail, "--book", str(tmp_path / "book.html")], "different rosettes"),
    ):
        assert cli.main([*to_h5, *given]) == 2
        assert re.search(reason, capfd.readouterr().err), given
    for wrong in ("0,0,0", "0,0:1,0,0", "=0,0,0:1,0,0", "0,0,0:0,0,0", "a=0,0,x:1,0,0"):
        with pytest.raises(SystemExit):
            cli.main([*to_h5, "--rosette", wrong])
        assert "write [NAME=]X,Y,Z:DX,DY,DZ" in capfd.readouterr().err
    assert sorted(os.listdir(tmp_path)) == ["base.brep", "layup.csv", "layup.h5"]
    assert cli.main([*to_h5, *nose, *tail]) == 0
    again = Read(tmp_path / "other.hdf5")
    assert all(numpy.array_equal(a["fibres"], b["fibres"]) for a, b in zip(read.plies, again.plies))


def test_rosettes_that_are_not_given(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    stack = lo.stack_plies(sample_shapes.bspline_face(), lo.Layup((lo.Ply("P1", "tape", 0.2, rosette="nose"),)))
    with pytest.raises(
        ValueError, match="name the rosette 'nose', which is not known; make a rosette .*and give it as rosette="
    ):
        stack.export(str(tmp_path / "layup.h5"))
    assert os.listdir(tmp_path) == []
    source, table, path = tmp_path / "base.brep", tmp_path / "layup.csv", tmp_path / "layup.h5"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    stack.layup.write(str(table))
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
    arguments += ["--hdf5", str(path), "--calculix", str(tmp_path / "section.inp")]
    assert cli.main(arguments) == 2 and "'nose', which is not known" in capfd.readouterr().err
    assert not path.exists()
    assert cli.main([*arguments, "--rosette", "nose=0,0,0:0,1,0"]) == 0
    assert Read(path).plies[0]["reference"][:, 1].min() > 0.7 and Read(path).plies[0]["rosettes"] == ["nose"]


def test_the_elements_do_not_bridge_a_crease(tmp_path: Path) -> None:
    stack = lo.stack_plies(sample_shapes.roof_face(20.0, 50.0), layup())
    with pytest.raises(
        ValueError, match="has a crease, which the elements of the HDF5 file would bridge; split the face there"
    ):
        stack.export(str(tmp_path / "layup.h5"))
    assert os.listdir(tmp_path) == []


def test_the_command_writes_all_files_or_none(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table, report = tmp_path / "roof.brep", tmp_path / "layup.csv", tmp_path / "report.json"
    (tmp_path / "plies.csv").write_bytes(b"old")

    def refused(face: Any, told: str, *more: str) -> None:
        files.write_shape(face, str(source), "roof")
        layup().write(str(table))
        arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
        arguments += [
            "--table",
            str(tmp_path / "plies.csv"),
            "--hdf5",
            str(tmp_path / "layup.h5"),
            "--report",
            str(report),
        ]
        assert cli.main([*arguments, *more]) == 2
        printed = capfd.readouterr()
        assert told in printed.err and "wrote" not in printed.err and printed.out == ""
        assert sorted(os.listdir(tmp_path)) == ["layup.csv", "plies.csv", "report.json", "roof.brep"]
        assert (tmp_path / "plies.csv").read_bytes() == b"old"
        written = json.loads(report.read_text(encoding="utf-8"))
        assert (written["status"], written["stage"]) == ("not-written", "export") and told in written["message"]
        assert len(written["stack"]) == written["plies"] == len(layup().physical_plies())

    refused(sample_shapes.roof_face(20.0, 50.0), "which the elements of the HDF5 file would bridge")
    # found out only while the last file is made
    refused(sample_shapes.cylinder_face(10.0, 20.0), "first axis stands on the surface", "--rosette", "0,10,0:0,1,0")


@pytest.mark.parametrize("wrong", ["x", 3, ((0, 0, 0), (1, 0, 0)), {"": (0, 0, 0)}])
def test_what_is_no_rosette_is_told(wrong: Any, tmp_path: Path) -> None:
    stack = lo.stack_plies(sample_shapes.bspline_face(), layup())
    with pytest.raises(TypeError, match=r"rosette(\[''\])? must be a Rosette"):
        lo.export_composite_cae(stack, str(tmp_path / "layup.h5"), rosette=wrong)
    for write, name in ((lo.export_calculix, "section.inp"), (lo.export_ply_book, "book.html")):
        with pytest.raises(TypeError, match="rosette must be a Rosette; it is "):
            write(stack, str(tmp_path / name), rosette=wrong)
    assert os.listdir(tmp_path) == []


def test_a_full_disk_leaves_the_old_file(python: Any, tmp_path: Path) -> None:
    path = tmp_path / "layup.h5"
    path.write_bytes(b"old")
    run = python(
        "import resource\n"
        "import laminate_offset as lo, Part\n"
        "from laminate_offset.replacing import FileError\n"
        "stack = lo.stack_plies(Part.makePlane(90, 90).Faces[0], lo.layup_from_notation('[0/90]', 'IM7-8552-134'))\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))\n"
        "try:\n"
        f"    stack.export({str(path)!r})\n"
        "except FileError as error:\n"
        "    print('refused:', error)\n"
        "print('alive')\n"
    )
    assert run.returncode == 0 and "alive" in run.stdout, run.stderr
    assert f"refused: {path}: cannot be written" in run.stdout
    assert path.read_bytes() == b"old" and os.listdir(tmp_path) == ["layup.h5"]


def test_what_cannot_be_written_says_why(tmp_path: Path) -> None:
    stack = lo.stack_plies(sample_shapes.bspline_face(), layup())
    path = str(tmp_path / "layup.h5")
    for size in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="element_size must be a finite length above zero"):
            lo.export_composite_cae(stack, path, size)
    with pytest.raises(ValueError, match=r"makes more than 2000000 elements on the face; give ([\d.e-]+) mm") as error:
        lo.export_composite_cae(stack, path, 1e-3)
    offered = float(re.search(r"give (\S+) mm", str(error.value)).group(1))
    assert stack.base_face.Area / (0.25 * 3.0**0.5 * offered**2) <= 2_000_000
    plane = lo.stack_plies(Part.makePlane(9, 9).Faces[0], layup())
    with pytest.raises(ValueError, match="stands on the surface"):
        lo.export_composite_cae(plane, path, rosette=lo.Rosette((0, 0, 0), (0, 0, 1)))
    with pytest.raises(FileError, match="cannot be written"):
        stack.export("/proc/layup.h5")
    assert os.listdir(tmp_path) == []


def test_without_h5py(python: Any, tmp_path: Path) -> None:
    code = (
        "import sys; sys.modules['h5py'] = None\n"
        "import laminate_offset as lo, Part\n"
        "from laminate_offset import cli\n"
        "from laminate_offset.replacing import FileError\n"
        "face = Part.makePlane(9, 9).Faces[0]\n"
        "stack = lo.stack_plies(face, lo.layup_from_notation('[0]', 'IM7-8552-134'))\n"
        "try:\n"
        f"    stack.export({str(tmp_path / 'layup.h5')!r})\n"
        "except FileError as error:\n"
        "    print(error)\n"
        f"face.exportBrep({str(tmp_path / 'base.brep')!r})\n"
        f"stack.layup.write({str(tmp_path / 'layup.csv')!r})\n"
        f"sys.exit(cli.main(['plies', {str(tmp_path / 'base.brep')!r}, '--face', '1', '--layup', {str(tmp_path / 'layup.csv')!r}, "
        f"'-o', {str(tmp_path / 'plies.step')!r}, '--hdf5', {str(tmp_path / 'layup.h5')!r}]))\n"
    )
    run = python(code)
    assert "need h5py (on Debian: apt-get install python3-h5py)" in run.stdout, run.stderr
    assert run.returncode == 2 and "need h5py" in run.stderr
    assert sorted(os.listdir(tmp_path)) == ["base.brep", "layup.csv"]


def test_the_command_writes_it(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    source, table, path = tmp_path / "base.brep", tmp_path / "layup.csv", tmp_path / "layup.h5"
    files.write_shape(sample_shapes.bspline_face(), str(source), "base")
    table.write_text("ply,material,thickness_mm,angle_deg\nP1,tape,0.2,0\nP2,tape,0.3,90\n", encoding="utf-8")
    arguments = ["plies", str(source), "--face", "1", "--layup", str(table), "-o", str(tmp_path / "plies.step")]
    assert cli.main([*arguments, "--hdf5", str(path)]) == 0
    assert f"wrote {path}" in capfd.readouterr().err
    assert [(ply["title"], ply["angle"]) for ply in Read(path).plies] == [("P1", 0.0), ("P2", 90.0)]
    assert cli.main([*arguments, "--hdf5", str(tmp_path / "layup.txt")]) == 2
    assert "--hdf5: " in capfd.readouterr().err
