# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stack in the layout "HDF5 composite CAE", by which tools for composites exchange layups: meshes, and for every ply its
material, its place in the stack and, element by element, thickness and directions.

docs/exports.md tells which names of the layout are certain, and which names or meanings we could not check and are listed in
the file itself.
"""

import datetime
import importlib
import math
import os
from typing import TYPE_CHECKING, Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy

from .. import _core
from ..api import Length, millimetres, nearest_point
from ..layup import PhysicalPly
from ..replacing import FileError, replacing
from ..rosette import Rosette, Rosettes, check_none_named, check_one_rosette, fibre_directions, rosette_of
from .fibres import Array, usual_rosette
from .triangles import crossed, triangles_of, with_short_sides

if TYPE_CHECKING:
    from ..stack import PlyStack, StackPly

ROOT = "composite_cae"
# Names of ours in the layout that no source at hand confirms.
UNCONFIRMED = (
    "components/*/mesh",
    "components/*/data_map/reference_directions",
    "components/*/data_map/fiber_directions",
    "rosettes/*.origin",
    "rosettes/*.direction",
)
# Names that a script reads from another tool's file; what they mean in full is our guess.
GUESSED = (
    "components/*.orientation",
    "components/*/rosettes",
    "components/*/data_map/thicknesses",
    "components/*/data_map/matorient_0_angles",
    "material_data/fabrics",
)
# How rosettes of several names are given.
ALL_ROSETTES = 'as rosette={"name": Rosette}'

# Of the lay-up face's size: the longest side of an element where nothing is asked for.
ELEMENT_PART = 1.0 / 40.0
# How far elements may lie from the face, in parts of their longest side, and the angle between neighbours in radians.
DEVIATION, ANGLE = 0.01, 0.1
# A mesh is not made finer than some so many elements.
MOST_ELEMENTS = 2_000_000


class Elements(NamedTuple):
    """Triangles on a part of the lay-up face.

    Attributes:
        points: array (n, 3) in mm.
        corners: array (m, 3), rows of the points, counter-clockwise as seen from where the plies are laid.
        uv: array (m, 2), parameters of the face's point nearest to each element's middle.
    """

    points: Array
    corners: Array
    uv: Array


def export_composite_cae(
    stack: "PlyStack", path: str, element_size: Optional[Length] = None, rosette: Optional[Rosettes] = None
) -> None:
    """Writes the stack in the layout "HDF5 composite CAE" (.h5), in mm.

    The plies lie on meshes of triangles on the lay-up surface; plies that cover the same part of it share theirs. The
    elements' normals point to where plies are laid, so they are opposite to the face's outward normal where the stack is
    laid against that; angles in the file count counter-clockwise about them. Every element has the ply's thickness, the
    direction that angles count from and that of the fibres.

    Args:
        element_size: the longest side of an element in mm, or a FreeCAD length. None: 1/40 of the lay-up face's diagonal.
        rosette: the axes that the plies' angles refer to, where rows of the layup name several all of them as
            {"name": Rosette}. None: the model's x axis on the middle of the surface, or the y axis where x stands too
            steeply on it; or the first axis of the model that stands nowhere on the face, as along a tube.

    Raises:
        FileError: the file cannot be written, or h5py is missing.
        ValueError: element_size is not above zero, or so small that there would be too many elements; rows of the layup
            name rosettes that are not given; a rosette's axis stands on the surface; or the face has creases.
        TypeError: rosette is neither a Rosette nor a mapping of them.
    """
    path = os.fspath(path)
    h5py = require_h5py()
    check_creases(stack)
    size = _element_size(stack, element_size)
    axes = _axes(stack, rosette)
    meshes = _meshes(stack, size)
    image = _image(h5py, stack, axes, meshes)
    with replacing(path) as temporary:
        with open(temporary, "wb") as file:
            file.write(image)


def check_creases(stack: "PlyStack") -> None:
    """Raises ValueError for the stack of a face with creases."""
    if any(ply.report.crease for ply in stack.plies):
        raise ValueError(
            "The lay-up face has a crease, which the elements of the HDF5 file would bridge; split the face there and export "
            "a stack of each part."
        )


def _image(h5py: Any, stack: "PlyStack", axes: Dict[str, Rosette], meshes: Dict[int, "Elements"]) -> bytes:
    """The file's bytes. They are made in memory: the HDF5 library does not survive a disk that is full when it closes."""
    try:
        with h5py.File("layup.h5", "w", driver="core", backing_store=False) as file:
            _Writer(h5py, file, stack, axes).write(meshes)
            file.flush()
            image: bytes = file.id.get_file_image()
            return image
    except RuntimeError as error:
        raise FileError(f"The layup cannot be put into the HDF5 layout: {error}.") from error


def require_h5py() -> Any:
    """The module h5py. Raises FileError where it is missing."""
    try:
        return importlib.import_module("h5py")
    except ImportError as error:
        raise FileError(f"HDF5 files need h5py (on Debian: apt-get install python3-h5py): {error}.") from error


def _element_size(stack: "PlyStack", asked: Optional[Length]) -> float:
    face = stack.base_face
    size: float = ELEMENT_PART * face.BoundBox.DiagonalLength if asked is None else millimetres(asked, "element_size")
    if not (size > 0.0 and math.isfinite(size)):
        raise ValueError(f"element_size must be a finite length above zero; it is {size:g} mm.")
    # Triangles with equal sides of that length need the fewest elements.
    least = face.Area / (0.25 * math.sqrt(3.0) * size * size)
    if least > MOST_ELEMENTS:
        raise ValueError(
            f"element_size {size:g} mm makes more than {MOST_ELEMENTS} elements on the face; give "
            f"{1.01 * size * math.sqrt(least / MOST_ELEMENTS):.3g} mm or more."
        )
    return size


def check_rosettes(plies: Sequence[PhysicalPly], rosette: Optional[Rosettes], given: str = ALL_ROSETTES) -> None:
    """Raises ValueError where rows name rosettes and none is given; `given` is how to give one."""
    if rosette is not None:
        return
    check_one_rosette(plies, f"give all of them {given}")
    check_none_named(plies, given)


def _axes(stack: "PlyStack", rosette: Optional[Rosettes]) -> Dict[str, Rosette]:
    """The rosettes by the names that rows have for them."""
    plies = [ply.ply for ply in stack.plies]
    check_rosettes(plies, rosette)
    chosen = usual_rosette(stack.base_face) if rosette is None else rosette
    return {ply.ply.rosette: rosette_of(chosen, ply.ply.rosette, plies, "rosette") for ply in plies}


def _meshes(stack: "PlyStack", size: float) -> Dict[int, Elements]:
    """One for every part of the face that plies cover, by the identity of that part."""
    parts = {id(ply.base_face): ply.base_face for ply in stack.plies}
    reversed_stack = stack.report["direction"] == "reversed"
    return {key: _elements(stack.base_face, part, size, reversed_stack) for key, part in parts.items()}


def _elements(face: Any, part: Any, size: float, inwards: bool) -> Elements:
    points, corners = triangles_of(part, DEVIATION * size, ANGLE)
    if not len(corners):
        raise FileError("No elements could be made on a ply's part of the lay-up face; ask for a smaller element_size.")
    points = _onto(part, points)  # FreeCAD's meshes have numbers of single precision
    points, corners = with_short_sides(points, corners, size, lambda middles: _onto(part, middles))
    uv = nearest_point(face, points[corners].mean(axis=1)).uv
    _, normals, _ = _core.evaluate_face(face, uv)
    turned = ((crossed(points[corners]) * normals).sum(axis=1) < 0.0) != inwards
    corners[turned] = corners[turned][:, ::-1]
    return Elements(points, corners, uv)


def _onto(part: Any, points: Array) -> Array:
    return nearest_point(part, points, trimmed=True).points


class _Writer:
    """Fills one file. What plies have in common is stored once."""

    def __init__(self, h5py: Any, file: Any, stack: "PlyStack", axes: Dict[str, Rosette]) -> None:
        self._h5py = h5py
        self._root = file.create_group(ROOT)
        self._stack = stack
        self._axes = axes
        self._sign = -1.0 if stack.report["direction"] == "reversed" else 1.0
        self._known: Dict[Tuple[Any, ...], Any] = {}

    def write(self, meshes: Dict[int, Elements]) -> None:
        now = datetime.datetime.now(datetime.timezone.utc)
        self._texts(
            self._root,
            format_version="1.0",
            last_modified=now.strftime("%Y-%m-%d %H:%M:%SZ"),
            vendor=f"LaminateOffset {_core.__version__}",
            unit_system="SI",
            length_unit="mm",
            unconfirmed_names=" ".join(UNCONFIRMED),
            guessed_meanings=" ".join(GUESSED),
        )
        places = {key: self._mesh(number, mesh) for number, (key, mesh) in enumerate(meshes.items(), start=1)}
        fabrics = self._fabrics()
        rosettes = self._rosettes()
        components = self._root.create_group("components")
        for ply in self._stack.plies:
            key, row = id(ply.base_face), ply.ply.ply
            component = components.create_group(f"component_{ply.ply.number}")
            self._title(component, ply.ply.name)
            component.attrs["layer_id"] = numpy.array([ply.ply.number], dtype=numpy.int32)
            component.attrs["orientation"] = numpy.array([self._sign * row.angle + 0.0])
            component["mesh"] = self._link(places[key])
            component["material"] = self._link(fabrics[row.material])
            component.create_group("rosettes")["rosette_1"] = self._link(rosettes[row.rosette])
            self._data_map(component.create_group("data_map"), ply, key, meshes[key])

    def _mesh(self, number: int, mesh: Elements) -> str:
        group = self._root.require_group("meshes").create_group(f"mesh_{number}")
        self._title(group, f"Lay-up surface, part {number}")
        group.create_dataset("nodes", data=mesh.points)
        group.create_dataset("element_nodes", data=mesh.corners.astype(numpy.int32))
        return str(group.name)

    def _fabrics(self) -> Dict[str, str]:
        names = list(dict.fromkeys(ply.ply.ply.material for ply in self._stack.plies))
        return self._named("material_data/fabrics", "fabric", names, names)

    def _rosettes(self) -> Dict[str, str]:
        titles = [name or "Rosette" for name in self._axes]
        places = self._named("rosettes", "rosette", list(self._axes), titles)
        for name, place in places.items():
            self._root[place].attrs["origin"] = numpy.array(self._axes[name].origin)
            self._root[place].attrs["direction"] = numpy.array(self._axes[name].direction)
        return places

    def _named(self, container: str, kind: str, keys: List[str], titles: List[str]) -> Dict[str, str]:
        """A group for every key, and where it is."""
        places = {}
        for number, (key, title) in enumerate(zip(keys, titles), start=1):
            group = self._root.require_group(container).create_group(f"{kind}_{number}")
            self._title(group, title)
            places[key] = str(group.name)
        return places

    def _data_map(self, group: Any, ply: "StackPly", key: int, mesh: Elements) -> None:
        physical, row = ply.ply, ply.ply.ply
        count, angle = len(mesh.corners), self._sign * row.angle + 0.0
        axes = self._axes[row.rosette]

        def directions(turn: float) -> Array:
            return fibre_directions(self._stack.base_face, mesh.uv, axes, turn)

        self._shared(group, "thicknesses", (key, physical.thickness), lambda: numpy.full(count, physical.thickness))
        self._shared(group, "matorient_0_angles", (key, angle), lambda: numpy.full(count, angle))
        self._shared(group, "reference_directions", (key, row.rosette), lambda: directions(0.0))
        self._shared(group, "fiber_directions", (key, row.rosette, row.angle), lambda: directions(row.angle))

    def _shared(self, group: Any, name: str, key: Tuple[Any, ...], make: Callable[[], Array]) -> None:
        """An array of numbers; one that another ply has already is stored once and has a second name."""
        if (name, *key) in self._known:
            group[name] = self._known[(name, *key)]
        else:
            self._known[(name, *key)] = group.create_dataset(name, data=make())

    def _title(self, group: Any, title: str) -> None:
        """The layout asks for `title`; files of other tools have it as `TITLE`."""
        self._texts(group, title=title, TITLE=title)

    def _texts(self, group: Any, **texts: str) -> None:
        """Attributes in UTF-8, of fixed length as in files of other tools."""
        for name, text in texts.items():
            content = text.encode("utf-8")
            group.attrs.create(name, content, dtype=self._h5py.string_dtype("utf-8", max(1, len(content))))

    def _link(self, place: str) -> Any:
        return self._h5py.SoftLink(place)
