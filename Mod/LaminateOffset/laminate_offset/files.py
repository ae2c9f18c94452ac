# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads faces from CAD files and writes shapes, without FreeCAD's GUI. Coordinates are in mm."""

import json
import os
import tempfile
import zipfile
from contextlib import contextmanager
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Set
from xml.etree.ElementTree import iterparse

import FreeCAD
import Part

from ._freecad import add_workbench_folders
from .replacing import FileError, replacing
from .view_settings import OFFSET_LOOK, Look, add_view_settings

FORMATS = {
    ".step": "STEP",
    ".stp": "STEP",
    ".iges": "IGES",
    ".igs": "IGES",
    ".brep": "BREP",
    ".brp": "BREP",
    ".fcstd": "FCStd",
}


def format_of(path: str) -> str:
    """The format by the name's ending, in any case: "STEP", "IGES", "BREP" or "FCStd"."""
    extension = os.path.splitext(path)[1]
    try:
        return FORMATS[extension.lower()]
    except KeyError:
        raise FileError(f"{path}: '{extension}' is not a known format; use one of {', '.join(FORMATS)}.") from None


def read_faces(path: str) -> List["Part.Face"]:
    """Every face of a STEP, IGES, BREP or FCStd file, in the order in which FreeCAD numbers them.

    Of an FCStd file the visible Part features count, in document order. Raises FileError.
    """
    file_format = format_of(path)
    if not os.path.isfile(path):
        raise FileError(f"{path}: there is no such file.")
    if not os.access(path, os.R_OK):
        raise FileError(f"{path}: reading it is not permitted.")
    try:
        shapes = _read_document(path) if file_format == "FCStd" else [_read_shape(path)]
    except Exception as error:  # the readers' own exceptions share no base class
        raise FileError(f"{path}: could not be read as {file_format}: {_reason(error)}") from error
    faces = [face for shape in shapes for face in shape.Faces]
    if not faces:
        of_what = "visible Part feature with faces" if file_format == "FCStd" else "face"
        raise FileError(f"{path}: it was read as {file_format} but holds no {of_what}.")
    return faces


def read_named_shapes(path: str) -> Dict[str, "Part.Shape"]:
    """The curves and faces of a file by their names: of an FCStd file the objects by their labels, of any other one the
    wires by their numbers from 1 ("1", "2", ...). Raises FileError.
    """
    file_format = format_of(path)
    if not os.path.isfile(path):
        raise FileError(f"{path}: there is no such file.")
    try:
        if file_format == "FCStd":
            shapes = _labelled_shapes(lambda: FreeCAD.openDocument(path, True))
        else:
            read = _read_shape(path)
            wires = read.Wires or [Part.Wire(edges) for edges in Part.sortEdges(read.Edges)]
            shapes = {str(number): wire for number, wire in enumerate(wires, start=1)}
    except Exception as error:  # the readers' own exceptions share no base class
        raise FileError(f"{path}: could not be read as {file_format}: {_reason(error)}") from error
    if not shapes:
        raise FileError(f"{path}: it was read as {file_format} but holds no curve.")
    return shapes


def write_shape(shape: "Part.Shape", path: str, label: str) -> None:
    """Writes a shape as STEP, IGES, BREP or FCStd (one Part feature of that label); replaces a file in one step."""
    write = {"STEP": _write_step, "IGES": _write_iges, "BREP": _write_brep, "FCStd": _write_document}[format_of(path)]
    with replacing(path) as temporary:
        write(shape, temporary, label)


def save_document(document: Any, path: str, looks: Optional[Mapping[str, Look]] = None) -> None:
    """Saves a document so that it opens in the GUI as meant, also when there is no GUI now; replaces a file in one step.

    looks: colours of objects by their names, where there is no GUI.
    """
    with replacing(path) as temporary:
        document.saveAs(temporary)
        add_view_settings(temporary, document, looks)


def write_json(content: Any, path: str) -> None:
    """Writes indented JSON; replaces a file in one step."""
    with replacing(path) as temporary:
        with open(temporary, "w", encoding="utf-8") as stream:
            json.dump(content, stream, indent=2, ensure_ascii=False)
            stream.write("\n")


def check_writable(path: str) -> None:
    """Raises FileError now if `path` could not be written later; leaves nothing behind."""
    if os.path.isdir(path):
        raise FileError(f"{path}: is a folder; name a file.")
    folder = os.path.dirname(os.path.realpath(path))
    if not os.path.isdir(folder):
        raise FileError(f"{path}: there is no folder {folder}; make it first.")
    try:
        os.rmdir(tempfile.mkdtemp(prefix=".laminate-offset-", dir=folder))
    except OSError as error:
        raise FileError(f"{path}: the folder cannot be written to: {error.strerror}.") from error


def _read_shape(path: str) -> "Part.Shape":
    shape = Part.Shape()
    shape.read(path)
    return shape


def _reason(error: Exception) -> str:
    """The exception's text; FreeCAD's own exceptions carry a dict instead."""
    details = error.args[0] if error.args else ""
    return str(details["sErrMsg"]) if isinstance(details, dict) and "sErrMsg" in details else str(error)


def _read_document(path: str) -> List["Part.Shape"]:
    add_workbench_folders()
    with closing_document(lambda: FreeCAD.openDocument(path, True)) as document:
        lost = _stored_names(path) - {feature.Name for feature in document.Objects}
        if lost:
            raise FileError(f"{', '.join(sorted(lost))} need a workbench that this FreeCAD cannot load")
        return [_placed_shape(feature) for feature in document.Objects if _is_shown(feature)]


def _labelled_shapes(make: Callable[[], Any]) -> Dict[str, "Part.Shape"]:
    with closing_document(make) as document:
        return {
            feature.Label: _placed_shape(feature)
            for feature in document.Objects
            if feature.isDerivedFrom("Part::Feature") and feature.Shape.Edges
        }


def _stored_names(path: str) -> Set[str]:
    """The names of the objects in the file: FreeCAD drops those whose workbench it cannot load."""
    with zipfile.ZipFile(path) as archive, archive.open("Document.xml") as stream:
        return {element.attrib["name"] for _, element in iterparse(stream) if element.tag == "Object"}


def _is_shown(feature: Any) -> bool:
    """True for a Part feature which the 3-D view would show, and only once: a body stands for its features."""
    if not feature.isDerivedFrom("Part::Feature") or feature.Shape.isNull():
        return False
    group = feature.getParentGeoFeatureGroup()
    if group is not None and group.isDerivedFrom("Part::BodyBase"):
        return False
    while feature is not None:
        if not feature.Visibility:
            return False
        feature = feature.getParentGeoFeatureGroup()
    return True


def _placed_shape(feature: Any) -> "Part.Shape":
    shape = feature.Shape.copy()
    shape.Placement = feature.getGlobalPlacement()
    return shape


@contextmanager
def closing_document(make: Callable[[], Any]) -> Iterator[Any]:
    """A document that is closed again, and the active document as it was."""
    before = FreeCAD.ActiveDocument.Name if FreeCAD.ActiveDocument is not None else None
    document = make()
    try:
        yield document
    finally:
        FreeCAD.closeDocument(document.Name)
        if before is not None:
            FreeCAD.setActiveDocument(before)


def _write_step(shape: "Part.Shape", path: str, _label: str) -> None:
    shape.exportStep(path)


def _write_iges(shape: "Part.Shape", path: str, _label: str) -> None:
    shape.exportIges(path)


def _write_brep(shape: "Part.Shape", path: str, _label: str) -> None:
    shape.exportBrep(path)


def _write_document(shape: "Part.Shape", path: str, label: str) -> None:
    name = os.path.splitext(os.path.basename(path))[0]
    with closing_document(lambda: FreeCAD.newDocument(name, hidden=True)) as document:
        feature = document.addObject("Part::Feature", "Offset")
        feature.Label = label
        feature.Shape = shape
        feature.purgeTouched()  # nothing is left to be computed
        document.saveAs(path)
        add_view_settings(path, document, {feature.Name: OFFSET_LOOK})
