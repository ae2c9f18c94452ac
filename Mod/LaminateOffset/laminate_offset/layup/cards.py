# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material cards: FreeCAD's .FCMat files, in the form of FreeCAD 0.20 (sections) and of 1.0 (YAML).

A card of ours has, beside FreeCAD's own properties, CuredPlyThickness, ArealWeight and RollWidth, with units.
"""

import os
import re
from typing import Any, Dict, Iterable, Mapping, Optional

from .errors import LayupError, Problem, quoted
from .model import Material
from .text_files import parse_yaml, read_text

_ADDON = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CARDS = os.path.join(_ADDON, "resources", "materials")

_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "um": 1e-3, "µm": 1e-3, "in": 25.4}
_AREAL_WEIGHTS = {"g/m^2": 1.0, "kg/m^2": 1000.0}
_DENSITIES = {"kg/m^3": 1.0, "g/cm^3": 1000.0, "kg/mm^3": 1e9, "t/mm^3": 1e12}
_QUANTITY = re.compile(r"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(\S*)")

# What a card calls the fields of Material, and their units in ours.
_QUANTITIES = {
    "CuredPlyThickness": ("cured_thickness", _LENGTHS),
    "ArealWeight": ("areal_weight", _AREAL_WEIGHTS),
    "Density": ("density", _DENSITIES),
    "RollWidth": ("roll_width", _LENGTHS),
}
_TEXTS = {"Description": "description", "ReferenceSource": "source"}


def materials(folder: Optional[str] = None) -> Dict[str, Material]:
    """The materials of the .FCMat cards in a folder, by their names and in the order of the files' names.

    Args:
        folder: the folder; None: the cards that come with the add-on.

    Raises:
        LayupError: the folder or a card cannot be read, or two cards have the same name.
    """
    folder = CARDS if folder is None else folder
    try:
        names = sorted(name for name in os.listdir(folder) if name.lower().endswith(".fcmat"))
    except OSError as error:
        raise LayupError(folder, [Problem("", error.strerror or "no folder", "a folder of .FCMat cards")]) from error
    found: Dict[str, Material] = {}
    for name in names:
        material = read_material(os.path.join(folder, name))
        if material.name in found:
            problem = Problem(
                "Name", quoted(material.name), "another name than those of the cards before it", unit="material"
            )
            raise LayupError(os.path.join(folder, name), [problem])
        found[material.name] = material
    return found


def known_materials(own: Iterable[Material]) -> Dict[str, Material]:
    """The library's materials and one's own, which come first where they have the same name."""
    return {**materials(), **{material.name: material for material in own}}


def read_material(path: str) -> Material:
    """The material of one .FCMat card; its name is the card's Name, or the file's name where that is missing.

    Raises LayupError: the file cannot be read, or a value has an unknown unit or is out of its range.
    """
    properties = read_card(path)
    values: Dict[str, Any] = {"name": properties.get("Name") or os.path.splitext(os.path.basename(path))[0]}
    problems = []
    for key, (field, units) in _QUANTITIES.items():
        if properties.get(key):
            try:
                values[field] = _quantity(properties[key], units)
            except ValueError:
                expected = f"a number and one of {', '.join(units)}"
                problems.append(Problem(key, quoted(properties[key]), expected, unit="material"))
    values.update({field: properties[key] for key, field in _TEXTS.items() if key in properties})
    if problems:
        raise LayupError(path, problems)
    try:
        return Material(**values)
    except LayupError as error:
        raise LayupError(path, error.problems) from error


def read_card(path: str) -> Dict[str, str]:
    """The properties of a .FCMat card as texts by their names, from all of its sections. Raises LayupError."""
    text = read_text(path)
    if text.lstrip().startswith(("---", "General:")):
        return dict(_flat(parse_yaml(text, path)))
    lines = [line for line in text.splitlines() if line and line[0] not in ";#["]
    pairs = [line.split("=", 1) for line in lines if "=" in line]
    return {key.strip(): value.strip() for key, value in pairs}


def _flat(tree: Any) -> Dict[str, str]:
    """The texts at the leaves of nested mappings; the first of equal names counts, which is the card's own."""
    properties: Dict[str, str] = {}
    for key, value in tree.items() if isinstance(tree, Mapping) else ():
        leaves = _flat(value) if isinstance(value, Mapping) else {key: value}
        for name, leaf in leaves.items():
            if isinstance(leaf, str):
                properties.setdefault(name, leaf)
    return properties


def _quantity(text: str, units: Mapping[str, float]) -> float:
    """The number in our unit; ValueError for anything but a number and one of these units."""
    found = _QUANTITY.fullmatch(text.strip())
    if not found or found.group(2) not in units:
        raise ValueError
    return float(found.group(1)) * units[found.group(2)]
