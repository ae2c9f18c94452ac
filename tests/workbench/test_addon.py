# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's files: what FreeCAD's Addon manager and its start need, and no GUI where it must not be."""

import ast
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import laminate_offset
import pytest

ADDON = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset"
NAMESPACE = "{https://wiki.freecad.org/Package_Metadata}"


def metadata():
    return ElementTree.parse(ADDON / "package.xml").getroot()


def test_the_tests_see_the_add_on_of_the_build_tree():
    assert pathlib.Path(laminate_offset.__file__).resolve().parent == (ADDON / "laminate_offset").resolve()


def test_package_metadata_has_what_the_addon_manager_needs():
    root = metadata()
    assert root.tag == NAMESPACE + "package" and root.get("format") == "1"
    for tag in ("name", "description", "version", "date", "maintainer", "license", "url", "icon", "content"):
        assert root.find(NAMESPACE + tag) is not None, f"<{tag}> is missing"
    assert root.find(NAMESPACE + "license").text == "LGPL-2.1-or-later"
    assert root.find(NAMESPACE + "maintainer").get("email").endswith("@example.org")
    assert root.find(NAMESPACE + "version").text == laminate_offset.__version__


def test_workbench_metadata_fits_the_code():
    workbench = metadata().find(f"{NAMESPACE}content/{NAMESPACE}workbench")
    assert workbench.find(NAMESPACE + "freecadmin").text == "0.20.0"
    name = workbench.find(NAMESPACE + "classname").text
    assert f"class {name}(" in (ADDON / "InitGui.py").read_text(encoding="utf-8")
    for icon in (metadata().find(NAMESPACE + "icon"), workbench.find(NAMESPACE + "icon")):
        assert (ADDON / icon.text).is_file(), icon.text


#: Modules that FreeCAD itself brings along, and our own.
BROUGHT_ALONG = {"FreeCAD", "FreeCADGui", "Part", "PySide", "pivy", "MeshPart", "laminate_offset"}


def imported_names(path):
    """The first parts of the names of modules that a file imports, or names to importlib.import_module."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "import_module":
            yield from (part.value.split(".")[0] for part in node.args if isinstance(part, ast.Constant))


def test_what_is_imported_is_a_dependency_of_the_package():
    used = {name for path in (ADDON / "laminate_offset").rglob("*.py") for name in imported_names(path)}
    others = used - set(sys.stdlib_module_names) - BROUGHT_ALONG
    depends = metadata().findall(f"{NAMESPACE}content/{NAMESPACE}workbench/{NAMESPACE}depend")
    assert {node.text for node in depends} == others == {"numpy", "yaml", "h5py", "matplotlib", "tqdm"}
    assert [node.text for node in depends if node.get("optional") == "false"] == ["numpy"]
    assert all(node.get("type") == "python" for node in depends)


ICONS = sorted(path.stem for path in (ADDON / "resources" / "icons").glob("*.svg"))


def test_every_command_and_object_has_an_icon():
    from laminate_offset.gui import commands

    assert set(commands.names()) | {"LaminateOffset", "LaminateOffset_Ply"} <= set(ICONS)


@pytest.mark.parametrize("name", ICONS)
def test_icons_are_drawings_of_64_by_64(name):
    root = ElementTree.parse(ADDON / "resources" / "icons" / f"{name}.svg").getroot()
    assert root.get("viewBox") == "0 0 64 64"
    assert len(root.findall(".//{http://www.w3.org/2000/svg}path")) >= 3


def test_init_files_do_not_use_their_own_path():
    for name in ("Init.py", "InitGui.py"):
        code = (ADDON / name).read_text(encoding="utf-8").split('"""', 2)[2]
        assert "__file__" not in code, f"{name}: FreeCAD 0.20 executes it without __file__"


def test_gui_modules_are_used_inside_gui_only():
    sources = [
        path
        for path in (ADDON / "laminate_offset").rglob("*.py")
        if "gui" not in path.relative_to(ADDON / "laminate_offset").parts
    ]
    assert len(sources) > 8
    for path in sources:
        found = re.search(r"^\s*(?:import|from)\s+(FreeCADGui|PySide\d?|pivy)\b", path.read_text("utf-8"), re.MULTILINE)
        assert not found, f"{path.name} imports {found.group(1)}"


def test_compounds_are_made_in_the_way_that_needs_no_application():
    """Part.makeCompound ends plain Python with FreeCAD 1.0; Part.Compound does not."""
    sources = list((ADDON / "laminate_offset").rglob("*.py"))
    assert any("Part.Compound(" in path.read_text("utf-8") for path in sources)
    assert not [path.name for path in sources if "makeCompound" in path.read_text("utf-8")]


_CREATE_WITHOUT_GUI = """
import sys
import FreeCAD as App
from laminate_offset.gui.commands.core_sample import CoreSampleCommand
from laminate_offset.gui.commands.curvature_map import CurvatureMapCommand
from laminate_offset.gui.commands.deviation_map import DeviationMapCommand
from laminate_offset.gui.commands.exploded_view import ExplodedViewCommand
from laminate_offset.gui.commands.export_stack import ExportStackCommand
from laminate_offset.gui.commands.extend_face import ExtendFaceCommand
from laminate_offset.gui.commands.layup import ExportLayupCommand, ImportLayupCommand, LayupCommand
from laminate_offset.gui.commands.offset_face import OffsetFaceCommand
from laminate_offset.gui.commands.offset_limits import OffsetLimitsCommand
from laminate_offset.gui.commands.ply_stack import PlyStackCommand
from laminate_offset.gui.commands.rosette import RosetteCommand
from laminate_offset.gui.commands.stack_section import StackSectionCommand
doc = App.newDocument("T")
ball = doc.addObject("Part::Sphere", "Ball")
can = doc.addObject("Part::Cylinder", "Can")
plane = doc.addObject("Part::Plane", "Plane")
doc.recompute()
links = [(ball, ["Face1"])]
offset = OffsetFaceCommand.create([*links, (can, ["Face1", "Face2"])], doc)
empty = OffsetFaceCommand.create([], doc)
limits = OffsetLimitsCommand.create(links, doc)
extended = ExtendFaceCommand.create([(plane, ["Face1"])], doc)
layup = LayupCommand.create(doc)
read = ImportLayupCommand.create(doc, sys.argv[1])
ExportLayupCommand.create(read, sys.argv[2])
stack = PlyStackCommand.create(links, read, doc)
sample = CoreSampleCommand.create(doc, stack, (10, 0, 0))
chart = CurvatureMapCommand.create(links, doc)
axes = RosetteCommand.create(doc, ball, "Face1")
doc.recompute()
section = StackSectionCommand.create(doc, stack)
ExplodedViewCommand.create(stack)
doc.recompute()
assert offset.Status == "ok" and len(offset.Shape.Faces) == 3, offset.Message
assert offset.Shape.Faces[0].Surface.Radius == 6, offset.Message
assert empty.Status == "null-shape" and empty.Shape.isNull()
assert abs(limits.Negative.Value + 5) < 0.01, limits.Message
assert extended.Status == "ok" and abs(extended.Shape.Area - 120**2) < 1e-6, extended.Message
assert layup.PlyCount == 1 and read.PlyCount == stack.PlyCount == sample.PlyCount == 6, sample.Message
map_ = DeviationMapCommand.create(offset)
assert map_.Status == "ok" and max(map(abs, map_.Deviations)) < 1e-6, map_.Message
assert chart.Status == "ok" and abs(chart.Inwards.Value + 5) < 1e-9, chart.Message
assert axes.Status == "ok" and abs(axes.FirstAxis.Length - 1) < 1e-12, axes.Message
assert section.Status == "ok" and section.PlyCount == 6, section.Message
ExportStackCommand.create(stack, sys.argv[3])
assert "FreeCADGui" not in sys.modules and "PySide" not in sys.modules
print("DONE")
"""


def test_commands_create_without_the_gui(tmp_path):
    source = ADDON / "resources" / "examples" / "layup_plain.csv"
    command = [
        sys.executable,
        "-c",
        _CREATE_WITHOUT_GUI,
        str(source),
        str(tmp_path / "copy.csv"),
        str(tmp_path / "plies.csv"),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "DONE" in done.stdout, done.stderr
    assert len((tmp_path / "plies.csv").read_text(encoding="utf-8").splitlines()) >= 7
    assert laminate_offset.read_layup(str(tmp_path / "copy.csv")) == laminate_offset.read_layup(str(source))
