# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material cards: those of the add-on are complete and consistent, and FreeCAD's own forms can be read."""

import os
import re
from pathlib import Path

import laminate_offset as lo
import pytest
from laminate_offset.layup.cards import CARDS, read_card

# Relative. Data sheets round thickness and density; areal weights follow from fibre weight and resin content.
WEIGHT_MARGIN = 0.005


def test_the_library_has_prepregs_fabrics_and_cores() -> None:
    kinds = [read_card(os.path.join(CARDS, name))["KindOfMaterial"] for name in os.listdir(CARDS)]
    assert kinds.count("UD prepreg") >= 3 and kinds.count("Fabric prepreg") >= 2 and kinds.count("Honeycomb core") >= 1
    assert len(lo.materials()) == len(kinds)
    assert list(lo.materials()) == sorted(lo.materials())


@pytest.mark.parametrize("name", sorted(lo.materials()))
def test_a_card_is_complete_and_consistent(name: str) -> None:
    material = lo.materials()[name]
    path = os.path.join(CARDS, f"{name}.FCMat")
    assert lo.read_material(path) == material
    assert material.source and material.description
    assert material.cured_thickness and material.density and material.areal_weight
    weight = material.cured_thickness * material.density
    assert abs(weight - material.areal_weight) <= WEIGHT_MARGIN * material.areal_weight
    card = read_card(path)
    if "ResinContent" in card:
        fibres = float(card["FibreArealWeight"].split()[0])
        resin = float(card["ResinContent"].split()[0]) / 100.0
        assert fibres / (1.0 - resin) == pytest.approx(material.areal_weight, rel=WEIGHT_MARGIN)
        assert f"{fibres:g} g/m2 of fibre, {resin:.0%}".replace("%", " %") in material.description


@pytest.mark.parametrize("name", sorted(lo.materials()))
def test_freecad_reads_our_cards(name: str, python) -> None:
    pytest.importorskip("FreeCAD")
    path = os.path.join(CARDS, f"{name}.FCMat")
    code = (
        "import FreeCAD, sys; sys.path.append(FreeCAD.getHomePath() + 'Mod/Material')\n"
        "sys.path.append('/usr/share/freecad/Mod/Material')\n"
        "try:\n    import importFCMat\nexcept ImportError:\n    print('absent'); sys.exit()\n"
        f"card = importFCMat.read({path!r})\n"
        "print(card['CardName'], FreeCAD.Units.Quantity(card['Density']).getValueAs('kg/m^3').Value)\n"
        "print(FreeCAD.Units.Quantity(card['CuredPlyThickness']).getValueAs('mm').Value)"
    )
    run = python(code)
    if "absent" in run.stdout:
        pytest.skip("this FreeCAD reads cards in another way")
    material = lo.materials()[name]
    first, second = run.stdout.strip().splitlines()[-2:]
    assert first.split()[0] == name, run.stderr
    assert float(first.split()[1]) == pytest.approx(material.density, rel=1e-12)
    assert float(second) == pytest.approx(material.cured_thickness, rel=1e-12)


def test_the_form_of_freecad_0_20(tmp_path: Path) -> None:
    path = tmp_path / "Steel.FCMat"
    path.write_text(
        "; Steel\n; somebody\n\n[General]\nName = Steel sheet\n# a comment\nDescription = a=b\n"
        "[Mechanical]\nDensity = 7.9 g/cm^3\n[UserDefined]\nCuredPlyThickness = 0.1 in\nRollWidth = 1.2 m\n",
        encoding="utf-8",
    )
    assert lo.read_material(str(path)) == lo.Material("Steel sheet", 2.54, None, 7900.0, 1200.0, "a=b")
    path.write_text("; Steel\n[General]\nFather = Metal\n")
    assert lo.read_material(str(path)) == lo.Material("Steel"), "a card without name is called like its file"


def test_the_form_of_freecad_1(tmp_path: Path) -> None:
    path = tmp_path / "CFRP.FCMat"
    path.write_text(
        "---\n# File created by a person\nGeneral:\n"
        '  UUID: "00000000-0000-0000-0000-000000000001"\n  Name: "CFRP sheet"\n  Description: "from a test"\n'
        'Models:\n  Density:\n    UUID: "00000000-0000-0000-0000-000000000002"\n    Density: "1600.00 kg/m^3"\n'
        '  Ply:\n    CuredPlyThickness: "250 um"\n    ArealWeight: "0.4 kg/m^2"\n',
        encoding="utf-8-sig",
    )
    assert lo.read_material(str(path)) == lo.Material("CFRP sheet", 0.25, 400.0, 1600.0, None, "from a test")


def test_freecads_own_glass_card_can_be_read() -> None:
    folder = Path("/usr/share/freecad/Mod/Material/StandardMaterial")
    if not folder.is_dir():
        pytest.skip("FreeCAD's cards are somewhere else")
    # Graphite's density is written with a comma, which might stand for thousands.
    paths = [path for path in folder.glob("*.FCMat") if path.stem not in ("None", "Graphite")]
    found = {path.stem: lo.read_material(str(path)) for path in paths}
    assert len(found) > 20
    assert found["Glass-E-GlassFibre"].density == 2580.0
    assert found["Glass-E-GlassFibre"].cured_thickness is None


@pytest.mark.parametrize(
    "line, words",
    [
        ("Density = 1600", "Density: found '1600', expected a number and one of kg/m^3"),
        ("Density = 1600 lb", "Density: found '1600 lb'"),
        ("CuredPlyThickness = thin mm", "CuredPlyThickness: found 'thin mm'"),
        ("CuredPlyThickness = -1 mm", "cured_thickness: found -1.0"),
        ("RollWidth = 0 mm", "roll_width: found 0.0"),
    ],
)
def test_a_wrong_card_says_what_is_wrong(line: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.FCMat"
    path.write_text(f"; bad\n[General]\nName = bad\n{line}\n")
    with pytest.raises(lo.LayupError, match=re.escape(words)) as caught:
        lo.read_material(str(path))
    assert caught.value.source == str(path)


def test_folders_of_ones_own(tmp_path: Path) -> None:
    for name in ("b", "a"):
        (tmp_path / f"{name}.FCMat").write_text(f"; {name}\n[UserDefined]\nCuredPlyThickness = 0.2 mm\n")
    (tmp_path / "notes.txt").write_text("no card")
    assert list(lo.materials(str(tmp_path))) == ["a", "b"]
    (tmp_path / "c.FCMat").write_text("; c\n[General]\nName = a\n")
    with pytest.raises(lo.LayupError, match="c.FCMat: Name: found 'a', expected another name"):
        lo.materials(str(tmp_path))
    with pytest.raises(lo.LayupError, match="No such file"):
        lo.materials(str(tmp_path / "absent"))
