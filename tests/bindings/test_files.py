# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading and writing CAD files: formats, faces of documents, units, and never a half-written file."""

import os
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD
import Part
import pytest
import sample_shapes
from laminate_offset import files
from laminate_offset._freecad import add_workbench_folders
from laminate_offset.view_settings import PART, Look, add_view_settings

ENDINGS = [".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd", ".STEP", ".IGS", ".Brep", ".FCStd"]


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_trimmed_face_survives_every_format(ending: str, tmp_path: Path) -> None:
    face = sample_shapes.moved(sample_shapes.trimmed_bspline_face())
    path = str(tmp_path / f"face{ending}")
    files.write_shape(face, path, "A face")
    (back,) = files.read_faces(path)
    assert back.Surface.TypeId == "Part::GeomBSplineSurface"
    assert (back.Surface.NbUPoles, back.Surface.NbVPoles) == (face.Surface.NbUPoles, face.Surface.NbVPoles)
    assert len(back.Wires) == 2
    assert back.Area == pytest.approx(face.Area, rel=1e-7)
    assert sample_shapes.deviation(face, back, 0.0) < 1e-6
    assert os.listdir(tmp_path) == [f"face{ending}"]


@pytest.mark.parametrize("ending", [".step", ".iges", ".brep", ".FCStd"])
def test_a_compound_keeps_its_order(ending: str, tmp_path: Path) -> None:
    radii = [3.0, 9.0, 5.0, 7.0]
    faces = [sample_shapes.trimmed_bspline_face()] + [sample_shapes.cylinder_face(radius) for radius in radii]
    path = str(tmp_path / f"all{ending}")
    files.write_shape(Part.Compound(faces), path, "All")
    areas = [face.Area for face in files.read_faces(path)]
    if ending == ".iges":  # IGES cuts a full cylinder at its seam or not, as the writer likes
        assert sum(areas) == pytest.approx(sum(face.Area for face in faces), rel=1e-6)
    else:
        assert areas == pytest.approx([face.Area for face in faces], rel=1e-6)


def test_step_is_in_millimetres(tmp_path: Path) -> None:
    path = tmp_path / "face.step"
    files.write_shape(sample_shapes.bspline_face(), str(path), "A face")
    text = path.read_text()
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    assert "B_SPLINE_SURFACE" in text and "OFFSET_SURFACE" not in text


def test_a_document_gives_its_visible_features_in_order(tmp_path: Path) -> None:
    path = str(tmp_path / "model.FCStd")
    add_workbench_folders()
    document = FreeCAD.newDocument("model", hidden=True)
    try:
        box = document.addObject("Part::Box", "Box")
        box.Placement.Base = FreeCAD.Vector(0.0, 0.0, 50.0)
        document.addObject("Part::Cylinder", "Hidden").Visibility = False
        container = document.addObject("App::Part", "Assembly")
        container.Placement.Base = FreeCAD.Vector(100.0, 0.0, 0.0)
        sphere = document.addObject("Part::Sphere", "Sphere")
        sphere.Placement.Base = FreeCAD.Vector(0.0, 7.0, 0.0)
        container.addObject(sphere)
        closed = document.addObject("App::Part", "HiddenAssembly")
        closed.addObject(document.addObject("Part::Torus", "InHiddenAssembly"))
        closed.Visibility = False
        body = document.addObject("PartDesign::Body", "Body")
        body.newObject("PartDesign::AdditiveBox", "BodyBox")
        document.recompute()
        document.saveAs(path)
    finally:
        FreeCAD.closeDocument(document.Name)
    faces = files.read_faces(path)
    assert [face.Surface.TypeId.replace("Part::Geom", "") for face in faces] == ["Plane"] * 6 + ["Sphere"] + [
        "Plane"
    ] * 6
    assert min(face.BoundBox.ZMin for face in faces[:6]) == pytest.approx(50.0)
    assert tuple(faces[6].BoundBox.Center) == pytest.approx((100.0, 7.0, 0.0), abs=1e-6)


def test_reading_a_document_leaves_the_open_ones_alone(tmp_path: Path) -> None:
    path = str(tmp_path / "face.FCStd")
    files.write_shape(sample_shapes.sphere_face(), path, "A sphere")
    own = FreeCAD.newDocument("own", hidden=True)
    try:
        files.read_faces(path)
        assert list(FreeCAD.listDocuments()) == [own.Name]
        assert FreeCAD.ActiveDocument.Name == own.Name
    finally:
        FreeCAD.closeDocument(own.Name)


def test_a_written_document_has_one_labelled_feature(tmp_path: Path) -> None:
    path = str(tmp_path / "face.FCStd")
    files.write_shape(sample_shapes.sphere_face(), path, "Offset 5 mm")
    document = FreeCAD.openDocument(path, True)
    try:
        assert [(thing.TypeId, thing.Label) for thing in document.Objects] == [("Part::Feature", "Offset 5 mm")]
        assert document.Objects[0].Shape.ShapeType == "Face"
    finally:
        FreeCAD.closeDocument(document.Name)


def test_a_document_saved_without_the_gui_opens_in_it_as_meant(tmp_path: Path) -> None:
    path = str(tmp_path / "model.FCStd")
    document = FreeCAD.newDocument("model", hidden=True)
    try:
        document.addObject("Part::Box", "Box")
        document.addObject("Part::Cylinder", "Cylinder").Visibility = False
        files.save_document(document, path, {"Box": Look((1.0, 0.5, 0.0), 35)})
    finally:
        FreeCAD.closeDocument(document.Name)
    with zipfile.ZipFile(path) as archive:
        views = {view.get("name"): view for view in ElementTree.fromstring(archive.read(PART)).iter("ViewProvider")}
    assert list(views) == ["Box", "Cylinder"]
    assert [view.find(".//Property[@name='Visibility']/Bool").get("value") for view in views.values()] == [
        "true",
        "false",
    ]
    assert views["Box"].find(".//Property[@name='ShapeColor']/PropertyColor").get("value") == str(0xFF800000)
    assert views["Box"].find(".//Property[@name='Transparency']/Integer").get("value") == "35"
    assert views["Cylinder"].find(".//Property[@name='ShapeColor']") is None
    assert os.listdir(tmp_path) == ["model.FCStd"]


def test_view_settings_of_the_gui_are_kept(tmp_path: Path) -> None:
    path = str(tmp_path / "model.FCStd")
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(PART, "the user's own")
    document = FreeCAD.newDocument("model", hidden=True)
    try:
        add_view_settings(path, document)
    finally:
        FreeCAD.closeDocument(document.Name)
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist() == [PART] and archive.read(PART) == b"the user's own"


def test_a_lost_object_is_not_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "face.FCStd"
    files.write_shape(sample_shapes.sphere_face(), str(path), "A sphere")
    with zipfile.ZipFile(path) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    members["Document.xml"] = members["Document.xml"].replace(b'type="Part::Feature"', b'type="NoSuch::Feature"')
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    with pytest.raises(files.FileError, match="Offset need a workbench"):
        files.read_faces(str(path))


@pytest.mark.parametrize("ending", [".step", ".igs", ".brep", ".FCStd"])
@pytest.mark.parametrize("content", [b"", b"junk\n", bytes(range(256)) * 40])
def test_junk_is_unreadable(ending: str, content: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"junk{ending}"
    path.write_bytes(content)
    with pytest.raises(files.FileError, match=f"junk{ending}: "):
        files.read_faces(str(path))


def test_a_cut_off_file_is_unreadable(tmp_path: Path) -> None:
    for ending in (".step", ".brep", ".FCStd"):
        path = tmp_path / f"cut{ending}"
        files.write_shape(sample_shapes.bspline_face(), str(path), "A face")
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
        with pytest.raises(files.FileError, match=f"cut{ending}: "):
            files.read_faces(str(path))


def test_what_cannot_be_read_says_why(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("text")
    edges = tmp_path / "edges.brep"
    files.write_shape(Part.makeCircle(3.0), str(edges), "An edge")
    for name, reason in [
        ("absent.step", "no such file"),
        ("notes.txt", "'.txt' is not a known format; use one of .step"),
        ("edges.brep", "holds no face"),
    ]:
        with pytest.raises(files.FileError, match=f"{name}: .*{reason}"):
            files.read_faces(str(tmp_path / name))


def test_a_failed_write_keeps_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "result.json"
    target.write_text("old")
    with pytest.raises(RuntimeError, match="half way"):
        with files.replacing(str(target)) as temporary:
            Path(temporary).write_text("new")
            raise RuntimeError("half way")
    with pytest.raises(TypeError):
        files.write_json({"value": object()}, str(target))
    assert target.read_text() == "old"
    assert os.listdir(tmp_path) == ["result.json"]


def test_a_link_is_written_through(tmp_path: Path) -> None:
    real = tmp_path / "real.json"
    real.write_text("old")
    link = tmp_path / "link.json"
    link.symlink_to(real)
    files.write_json([1], str(link))
    assert link.is_symlink() and real.read_text().split() == ["[", "1", "]"]


def test_unwritable_places_are_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    for path, reason in [
        (tmp_path, "is a folder"),
        (tmp_path / "absent" / "a.step", "there is no folder"),
        (tmp_path / "file" / "a.step", "there is no folder"),
        (Path("/proc/a.step"), "cannot be written to"),
    ]:
        with pytest.raises(files.FileError, match=reason):
            files.check_writable(str(path))
    with pytest.raises(files.FileError, match="cannot be written"):
        files.write_json([], "/proc/a.json")
