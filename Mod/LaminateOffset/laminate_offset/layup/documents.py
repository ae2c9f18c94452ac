# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole jobs as JSON or YAML: materials, plies and options in one document.

    format: laminate-offset layup
    version: 1
    repeat: 1                   # with symmetric, middle_ply, direction and reference: the options of a Layup
    symmetric: true
    materials:                  # left out: those of the library that the plies name
      - {material: CFRP, cured_thickness_mm: 0.131, areal_weight_g_m2: 206, density_kg_m3: 1570, roll_width_mm: 300}
    plies:
      - {ply: P1, material: CFRP, angle_deg: 45, count: 2}

The fields of materials and plies have the names of a table's columns; what has its default may be left out.
"""

from typing import Any, Dict, Iterable, List, Mapping, Sequence, Tuple

from .errors import LayupError, Problem, quoted
from .fields import LAYUP_FIELDS, MATERIAL_FIELDS, PLY_FIELDS, Field
from .model import Layup, Material, used_materials
from .records import Record, build_materials, build_plies, parse, together

FORMAT = "laminate-offset layup"
VERSION = 1


def layup_document(layup: Layup) -> Dict[str, Any]:
    """A layup as plain dicts, lists, numbers and texts, without what has its default."""
    return {
        "format": FORMAT,
        "version": VERSION,
        **_entry(layup, LAYUP_FIELDS),
        "materials": [_entry(material, MATERIAL_FIELDS) for material in layup.materials],
        "plies": [_entry(ply, PLY_FIELDS) for ply in layup.plies],
    }


def read_document(document: Any, source: str, known: Mapping[str, Material]) -> Layup:
    """The layup of a document. Raises LayupError with every problem in it.

    Args:
        document: what JSON or YAML gave.
        source: what messages call it.
        known: the materials by their names that a ply without thickness may name beside those of the document.
    """
    problems = _frame_problems(document)
    if problems:
        raise LayupError(source, problems)
    options, problems = _options(document)
    listed, ply_entries = document.get("materials"), document["plies"]
    material_records, wrong = _records(listed or [], MATERIAL_FIELDS, "material")
    records, unknown = _records(ply_entries, PLY_FIELDS, "ply")
    materials, bad_materials = build_materials(material_records)
    plies, bad_plies = build_plies(records)
    others = [known[name] for name in known if name not in {material.name for material in materials}]
    problems += wrong + bad_materials + unknown + bad_plies
    problems += together(plies, [*materials, *others], {"ply": records, "material": material_records})
    if problems:
        raise LayupError(source, problems)
    incomplete = [ply for ply in plies if listed is None or ply.thickness is None]
    used = used_materials(incomplete, {material.name: material for material in others})
    try:
        return Layup(tuple(plies), (*materials, *used), **options)
    except LayupError as error:
        raise LayupError(source, error.problems) from error


def _entry(thing: Any, rules: Iterable[Field]) -> Dict[str, Any]:
    """The fields of a thing by their columns, without those that have their default."""
    entry: Dict[str, Any] = {}
    for rule in rules:
        value = getattr(thing, rule.name)
        if rule.name in ("name", "material", "angle") or not _is_default(rule, value):
            entry[rule.column] = dict(value) if rule.name == "limits" else value
    return entry


def _is_default(rule: Field, value: Any) -> bool:
    return bool(value == rule.parse(None))


def _frame_problems(document: Any) -> List[Problem]:
    """What is wrong with the document before its entries are looked at."""
    if not isinstance(document, Mapping):
        return [Problem("", f"{_kind(document)}", "a mapping with format, materials and plies")]
    problems = []
    if document.get("format") != FORMAT:
        problems.append(Problem("format", quoted(document.get("format")), repr(FORMAT)))
    if str(document.get("version")) != str(VERSION):
        problems.append(Problem("version", quoted(document.get("version")), f"{VERSION}, which this version reads"))
    for key in ("materials", "plies"):
        entries = document.get(key)
        if not isinstance(entries, list) and (key == "plies" or entries is not None):
            problems.append(Problem(key, _kind(entries), "a list"))
    names = ["format", "version", *[rule.column for rule in LAYUP_FIELDS], "materials", "plies"]
    problems += [
        Problem(str(key), "a key that is not known", f"one of {', '.join(names)}")
        for key in document
        if key not in names
    ]
    return [_of_the_document(problem) for problem in problems]


def _options(document: Mapping[str, Any]) -> Tuple[Dict[str, Any], List[Problem]]:
    values = {rule.name: document.get(rule.column) for rule in LAYUP_FIELDS}
    options, problems = parse(LAYUP_FIELDS, Record(0, "document", values))
    return options, [_of_the_document(problem) for problem in problems]


def _of_the_document(problem: Problem) -> Problem:
    return Problem(problem.column, problem.found, problem.expected, unit="document")


def _records(entries: Sequence[Any], rules: Iterable[Field], unit: str) -> Tuple[List[Record], List[Problem]]:
    """A record for every entry, and a problem for every entry or key that is none of ours."""
    names = {rule.column: rule.name for rule in rules}
    records, problems = [], []
    for row, entry in enumerate(entries, start=1):
        if not isinstance(entry, Mapping):
            problems.append(Problem("", _kind(entry), f"a mapping with {', '.join(names)}", row, unit))
            entry = {}
        unknown = [key for key in entry if key not in names]
        problems += [
            Problem(str(key), "a key that is not known", f"one of {', '.join(names)}", row, unit) for key in unknown
        ]
        records.append(Record(row, unit, {names[key]: entry[key] for key in entry if key in names}))
    return records, problems


def _kind(value: Any) -> str:
    words = {type(None): "nothing", list: "a list", dict: "a mapping"}
    return words.get(type(value), quoted(value))
