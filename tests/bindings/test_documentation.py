# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written about the interface is true: stubs, annotations, defaults, units and signs."""

import ast
import inspect
import subprocess
import sys
from pathlib import Path
from typing import Set

import laminate_offset as lo
import pytest
from laminate_offset import _core

PACKAGE = Path(lo.__file__).parent


def names_in_stub() -> Set[str]:
    """The names that _core.pyi declares."""
    names = set()
    for node in ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8")).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names.add(node.target.id)
    return names


def arguments_in_stub(function: str) -> list:
    """The argument names that _core.pyi gives a function."""
    body = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8")).body
    node = next(node for node in body if isinstance(node, ast.FunctionDef) and node.name == function)
    return [argument.arg for argument in node.args.args]


def test_the_stub_has_the_modules_names() -> None:
    module_names = {name for name in dir(_core) if not name.startswith("__")} | {"__version__"}
    assert len(module_names) > 5
    assert names_in_stub() == module_names


FUNCTIONS = [
    name for name in dir(_core) if callable(getattr(_core, name)) and not isinstance(getattr(_core, name), type)
]


@pytest.mark.parametrize("function", FUNCTIONS)
def test_the_stub_has_the_functions_arguments(function: str) -> None:
    signature = getattr(_core, function).__doc__.splitlines()[0]
    arguments = arguments_in_stub(function)
    assert all(f"{argument}: " in signature for argument in arguments), signature
    assert signature.split(" -> ")[0].count(": ") == len(arguments), signature


def test_the_package_is_typed() -> None:
    assert (PACKAGE / "py.typed").is_file()
    pytest.importorskip("mypy", reason="mypy is not installed")
    modules = [
        PACKAGE / f"{name}.py"
        for name in "__init__ _freecad api cli each_face errors exchange files replacing report".split()
    ]
    for folder in ("batch", "commands", "export", "layup"):
        modules += sorted((PACKAGE / folder).glob("*.py"))
    command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--follow-imports=silent"]
    command += ["--cache-dir=/dev/null", "--config-file=", *map(str, modules)]
    run = subprocess.run(command, capture_output=True, text=True, cwd=PACKAGE.parent)
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_documented_defaults_are_the_engines() -> None:
    engine = _core.default_options()
    signature = inspect.signature(lo.offset_face).parameters
    for name in ("tolerance", "method", "extension"):
        assert signature[name].default == engine[name]
    assert signature["max_degree"].default is None
    assert "from 3 to 7" in inspect.getdoc(lo.offset_face)
    face = lo.api.Part.makeSphere(10.0).Faces[0]
    for degree in (2, 8):
        with pytest.raises(ValueError, match="3 to 7"):
            lo.offset_face(face, 1.0, max_degree=degree)
    for degree in (3, 7):
        assert lo.offset_face(face, 1.0, max_degree=degree).report.status == "ok"


def test_docstrings_state_units_and_sign() -> None:
    text = " ".join(inspect.getdoc(lo.offset_face).split())
    assert "signed distance in mm" in text
    assert "outward normal" in text
    assert "reversing the face turns the sign" in text
    for documented in (lo, lo.OffsetReport, lo.OffsetError):
        text = " ".join(inspect.getdoc(documented).split())
        assert "mm" in text and "outward normal" in text
    assert "outward normal" in _core.offset_face.__doc__


def test_everything_public_has_a_docstring() -> None:
    for name in lo.__all__:
        thing = getattr(lo, name)
        assert inspect.getdoc(thing), name
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if inspect.isfunction(value) and not member.startswith("_"):
                assert inspect.getdoc(value), f"{name}.{member}"


def test_nothing_is_offered_that_is_not_there_yet() -> None:
    names = "Boundary CoreLayer CoreSample CurveProjection ExtensionReport ExtensionResult Layup LayupError "
    names += "MassProperties Material MaterialSolid MaterialTotal NearestPoints OffsetError OffsetLimits OffsetReport "
    names += "OffsetResult PhysicalPly Ply PlyProperties PlyStack Rosette StackPly export_calculix export_composite_cae export_ply_book extend_face layup_from_notation "
    names += "materials nearest_point offset_face offset_limits project_curve read_layup read_material "
    names += "shape_exchange stack_plies"
    assert sorted(lo.__all__) == names.split()
