# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups in tables and documents: nothing is lost, and what is wrong is named by file, row and column."""

import json
import os
import random
import re
from pathlib import Path
from typing import Any, Dict, List

import laminate_offset as lo
import layup_cases
import pytest

ROOT = Path(os.environ.get("LAMINATE_OFFSET_PROJECT_DIR", Path(__file__).resolve().parents[2]))
EXAMPLES = ROOT / "resources" / "examples"
HEADER = "ply,material,thickness_mm,angle_deg,count,boundary,active,rosette\n"
STACK_UP_HEADER = (
    "Plies Group,Sequence,Ply,Material,Orientation,Starting Plane,End Plane,LEFT LIMIT,Offset,RIGHT LIMIT,Offset 2\n"
)


def read(tmp_path: Path, content: Any, name: str = "layup.csv") -> lo.Layup:
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
    return lo.read_layup(str(path))


def problems(tmp_path: Path, content: Any, name: str = "layup.csv") -> List[Any]:
    """(row, column, found) of every problem of a file."""
    with pytest.raises(lo.LayupError) as caught:
        read(tmp_path, content, name)
    assert caught.value.source == str(tmp_path / name)
    assert str(caught.value).startswith(str(tmp_path / name))
    assert all(str(problem) in str(caught.value) for problem in caught.value.problems)
    return [(problem.row, problem.column, problem.found) for problem in caught.value.problems]


def test_the_plain_table(tmp_path: Path) -> None:
    rows = "P1,IM7-8552-134,,45,2,Contour1,yes,Rosette1\nP2,stuff,0.25,-30.5,,,0,\nP3,IM7-8552-134,0.125,0\n"
    stack = read(tmp_path, HEADER + rows)
    assert stack.plies == (
        lo.Ply("P1", "IM7-8552-134", None, 45.0, 2, "Contour1", True, "Rosette1"),
        lo.Ply("P2", "stuff", 0.25, -30.5, 1, "", False, ""),
        lo.Ply("P3", "IM7-8552-134", 0.125, 0.0),
    )
    assert stack.materials == (lo.materials()["IM7-8552-134"],)
    assert stack == lo.Layup(stack.plies, stack.materials)
    stack.write(str(tmp_path / "back.csv"))
    written = (tmp_path / "back.csv").read_text(encoding="utf-8")
    assert written.startswith(HEADER) and "P1,IM7-8552-134,,45,2,Contour1,1,Rosette1\n" in written


@pytest.mark.parametrize("bom", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
def test_separators_line_ends_and_byte_order_marks(tmp_path: Path, delimiter: str, end: str, bom: bytes) -> None:
    lines = ["", "PLY,Material, angle_deg ,thickness_mm,,", "", "Größe 1,stuff,-22.5,0.25,,", "", "P2, stuff ,90,1"]
    stack = read(tmp_path, bom + end.join(lines).replace(",", delimiter).encode("utf-8"))
    assert stack.plies == (lo.Ply("Größe 1", "stuff", 0.25, -22.5), lo.Ply("P2", "stuff", 1.0, 90.0))


def test_decimal_commas_where_semicolons_separate(tmp_path: Path) -> None:
    stack = read(tmp_path, "ply;material;thickness_mm;angle_deg\nP1;stuff;0,125;-22,5\n")
    assert (stack.plies[0].thickness, stack.plies[0].angle) == (0.125, -22.5)
    quoted = 'ply,material,thickness_mm,angle_deg\nP1,stuff,"0,125",0\n'
    assert problems(tmp_path, quoted) == [(2, "thickness_mm", "'0,125'")], "a comma may stand for thousands, too"
    limits = "Sequence;Ply;Material;Orientation;Limit 1;Offset 1\nS1;P1;AS4-8552-190;45;a,b;12,5\n"
    assert read(tmp_path, limits).plies[0].limits == (("Limit 1", "a,b"), ("Offset 1", "12.5"))


def test_the_stack_up_table(tmp_path: Path) -> None:
    rows = "Skin,Seq.1,Ply.1,AS4-8552-190,45,2000,4000,S.2,15,S.5,-15\n,Seq.2,Ply.2,IM7-8552-190,-45,,,,,,\n"
    stack = read(tmp_path, STACK_UP_HEADER + rows)
    limits = dict(zip(STACK_UP_HEADER.strip().split(",")[5:], ["2000", "4000", "S.2", "15", "S.5", "-15"]))
    assert stack.plies[0] == lo.Ply(
        *("Ply.1", "AS4-8552-190", None, 45.0), group="Skin", sequence="Seq.1", limits=tuple(limits.items())
    )
    assert stack.thickness == pytest.approx(0.185 + 0.186)
    stack.write(str(tmp_path / "back.csv"), table="stack-up")
    assert (tmp_path / "back.csv").read_text() == STACK_UP_HEADER + rows
    without = "Sequence,Ply,Material,Orientation\nS1,P1,AS4-8552-190,45\n"
    assert read(tmp_path, without).plies == (lo.Ply("P1", "AS4-8552-190", angle=45.0, sequence="S1"),)


@pytest.mark.parametrize("table", ["plain", "stack-up"])
def test_tables_lose_nothing(tmp_path: Path, table: str) -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    path = str(tmp_path / "layup.csv")
    rows = 0
    for _ in range(150):
        stack = layup_cases.random_table(rng, table)
        stack.write(path, table=table)
        assert lo.read_layup(path) == stack, f"seed {seed}"
        rows += len(stack.plies)
    assert rows > 500
    assert os.listdir(tmp_path) == ["layup.csv"]


@pytest.mark.parametrize("ending", ["json", "yaml", "YML"])
def test_documents_lose_nothing(tmp_path: Path, ending: str) -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    path = str(tmp_path / f"job.{ending}")
    symmetric = 0
    for _ in range(60):
        stack = layup_cases.random_job(rng)
        stack.write(path)
        assert lo.read_layup(path) == stack, f"seed {seed}"
        symmetric += stack.symmetric
    assert 10 < symmetric < 50


def test_a_table_is_not_written_where_something_would_be_lost(tmp_path: Path) -> None:
    path = tmp_path / "layup.csv"
    path.write_text("old")
    own = lo.Material("mine", 0.2)
    plies = [lo.Ply("P1", "mine"), lo.Ply("P2", "mine", 0.3, limits={"End Plane": "S"})]
    stack = lo.Layup(plies, [own], repeat=2, symmetric=True, direction="reversed", reference="top")
    with pytest.raises(lo.LayupError) as caught:
        stack.write(str(path))
    lost = [problem.place for problem in caught.value.problems]
    assert lost == ["repeat", "symmetric", "direction", "reference", "materials", "ply 2, limits"]
    assert "write a .json or .yaml file" in str(caught.value)
    ply = lo.Ply("P1", "IM7-8552-134", 0.3, 0.0, 2, "Contour", False, "Rosette")
    with pytest.raises(lo.LayupError) as caught:
        lo.Layup([ply]).write(str(path), table="stack-up")
    names = [problem.column for problem in caught.value.problems]
    assert names == ["thickness_mm", "count", "boundary", "active", "rosette"]
    mixed = [
        lo.Ply("P1", "IM7-8552-134", limits={"End Plane": "S"}),
        lo.Ply("P2", "IM7-8552-134", limits={"Limit 4": "a"}),
    ]
    with pytest.raises(lo.LayupError, match="ply 1, limits"):
        lo.Layup(mixed, [lo.materials()["IM7-8552-134"]]).write(str(path), table="stack-up")
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["layup.csv"]


@pytest.mark.parametrize(
    "row, column, found",
    [
        (",m,1,0", "ply", "nothing"),
        ("P2,,1,0", "material", "nothing"),
        ("P2,m,0,0", "thickness_mm", "'0'"),
        ("P2,m,-0.1,0", "thickness_mm", "'-0.1'"),
        ("P2,m,thin,0", "thickness_mm", "'thin'"),
        ("P2,m,nan,0", "thickness_mm", "'nan'"),
        ("P2,m,,0", "thickness_mm", "nothing"),
        ("P2,m,1,", "angle_deg", "nothing"),
        ("P2,m,1,181", "angle_deg", "'181'"),
        ("P2,m,1,4S", "angle_deg", "'4S'"),
        ("P2,m,1,0,0", "count", "'0'"),
        ("P2,m,1,0,1.5", "count", "'1.5'"),
        ("P2,m,1,0,two", "count", "'two'"),
        ("P2,m,1,0,1,\x07", "boundary", "'\\x07'"),
        ("P2,m,1,0,1,,maybe", "active", "'maybe'"),
        ("P2,m,1,0,1,,1,\x00x", None, None),
        ("P1,m,1,0", "ply", "'P1'"),
        ("P2,m,1,0,1,,1,R,extra", "", "'extra' in cell 9"),
    ],
)
def test_errors_name_row_and_column(tmp_path: Path, row: str, column: Any, found: Any) -> None:
    reported = problems(tmp_path, HEADER + "P1,m,1,0\n\n" + row + "\nP9,m,1,0\n")
    assert len(reported) == 1
    if column is not None:
        assert reported == [(4, column, found)], "rows count as in a spreadsheet, empty ones too"


def test_all_problems_are_in_one_message(tmp_path: Path) -> None:
    rows = "P1,m,0,400,0,,perhaps,\nP1,m,1,0\nP3,nothing known,,x\n,IM7-8552-134,,0\n"
    assert problems(tmp_path, HEADER + rows) == [
        (2, "thickness_mm", "'0'"),
        (2, "angle_deg", "'400'"),
        (2, "count", "'0'"),
        (2, "active", "'perhaps'"),
        (3, "ply", "'P1'"),
        (4, "angle_deg", "'x'"),
        (4, "thickness_mm", "nothing"),
        (5, "ply", "nothing"),
    ]
    with pytest.raises(lo.LayupError, match="row 3, column ply: found 'P1', expected a name that no ply before it has"):
        read(tmp_path, HEADER + rows)
    with pytest.raises(lo.LayupError, match="'nothing known' is not known: one of AS4-8552-134, "):
        read(tmp_path, HEADER + rows)


@pytest.mark.parametrize(
    "content, row, column",
    [
        ("", 1, ""),
        (" \n\n", 1, ""),
        ("ply,material,thickness_mm\nP1,m,1\n", 1, "angle_deg"),
        ("ply,material,thickness_mm,angle_deg,boundry\n", 1, "boundry"),
        ("ply,material,thickness_mm,angle_deg,Ply\n", 1, "Ply"),
        ("ply,material,,thickness_mm,angle_deg\n", 1, "number 3"),
        ("Sequence,Ply,Orientation\n", 1, "Material"),
        ("Sequence,Ply,Material,Orientation,Limit 1,End Plane\n", 1, "End Plane"),
        ("Sequence,Ply,Material,Orientation\nS,P,AS4-8552-190,x\n", 2, "Orientation"),
        ("Sequence,Ply,Material,Orientation\nS,P,unknown,0\n", 2, "thickness_mm"),
        ("Sequence,Ply,Material,Orientation,Offset\nS,P,AS4-8552-190,0,far\n", 2, "Offset"),
        ("ply,material,thickness_mm,angle_deg,,\nP1,m,1,0,5\n", 2, ""),
        (HEADER, None, "plies"),
        (HEADER + 'P1,"m\n', 2, ""),
        (HEADER.encode() + b"P1,m\xfc,1,0\n", None, ""),
    ],
)
def test_a_wrong_table_says_where(tmp_path: Path, content: Any, row: Any, column: str) -> None:
    assert [(place, name) for place, name, _ in problems(tmp_path, content)] == [(row, column)]


def document(**changes: Any) -> Any:
    plies = [{"ply": "P1", "material": "IM7-8552-134", "angle_deg": 0}]
    content = {"format": "laminate-offset layup", "version": 1, "plies": plies, **changes}
    return {key: value for key, value in content.items() if value is not ...}


@pytest.mark.parametrize(
    "changes, place",
    [
        ({"format": ...}, "format"),
        ({"version": 2}, "version"),
        ({"plies": ...}, "plies"),
        ({"plies": {}}, "plies"),
        ({"plies": []}, "plies"),
        ({"materials": 5}, "materials"),
        ({"symetric": True}, "symetric"),
        ({"symmetric": "perhaps"}, "symmetric"),
        ({"middle_ply": True}, "middle_ply"),
        ({"direction": "up"}, "direction"),
        ({"repeat": 0}, "repeat"),
        ({"plies": [{"ply": "P1", "material": "m", "angle_deg": 0}]}, "ply 1, thickness_mm"),
        ({"plies": [{"ply": "P1", "material": "m", "thickness_mm": 1}]}, "ply 1, angle_deg"),
        ({"plies": [{"ply": "P1", "material": "m", "thickness_mm": True, "angle_deg": 0}]}, "ply 1, thickness_mm"),
        ({"plies": [{"ply": "P1", "material": "m", "thickness_mm": 1, "angle_deg": 0, "angel": 1}]}, "ply 1, angel"),
        ({"materials": [{"material": "a", "density_kg_m3": -1}]}, "material 1, density_kg_m3"),
        ({"materials": [{"material": "a"}, {"material": "a"}]}, "material 2, material"),
        (
            {"materials": [{"material": "a", "cured_thickness_mm": 1, "areal_weight_g_m2": 1, "density_kg_m3": 9}]},
            "material 1, areal_weight_g_m2",
        ),
    ],
)
def test_a_wrong_document_says_where(tmp_path: Path, changes: Any, place: str) -> None:
    (tmp_path / "job.json").write_text(json.dumps(document(**changes)))
    with pytest.raises(lo.LayupError) as caught:
        lo.read_layup(str(tmp_path / "job.json"))
    assert [problem.place for problem in caught.value.problems] == [place]


def test_entries_of_documents_must_be_mappings(tmp_path: Path) -> None:
    for content in ([], 5, None, "text"):
        (tmp_path / "job.json").write_text(json.dumps(content))
        with pytest.raises(lo.LayupError, match="expected a mapping with format, materials and plies"):
            lo.read_layup(str(tmp_path / "job.json"))
    assert (1, "", "5") in problems(tmp_path, json.dumps(document(plies=[5])), "job.json")


@pytest.mark.parametrize(
    "name, content, words",
    [
        ("a.json", '{"format": \n x}', "line 2, column 2"),
        ("a.json", '{"plies": [], "plies": []}', "the key 'plies' twice"),
        ("a.json", '{"repeat": NaN}', "NaN, which is no number"),
        ("a.json", "[" * 100000, "too many levels"),
        ("a.yaml", "plies: [\n", "line 2"),
        ("a.yaml", "plies: 1\nplies: 2\n", "the key 'plies' twice"),
        ("a.yaml", "plies: &a [*a]\n", "recursive"),
        ("a.yaml", "? [1]\n: 2\n", "a.yaml"),
        ("a.yaml", "!!python/object/apply:os.system [ls]\n", "a list"),
    ],
)
def test_broken_json_and_yaml(tmp_path: Path, name: str, content: str, words: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(lo.LayupError) as caught:
        lo.read_layup(str(tmp_path / name))
    assert words in str(caught.value)


def test_yaml_means_what_it_shows(tmp_path: Path) -> None:
    text = (
        "format: laminate-offset layup\nversion: 1\nsymmetric: yes\n"
        "plies:\n- {ply: 010, material: no, thickness_mm: 1e-1, angle_deg: -45, count: 2, active: off}\n"
    )
    assert [(row, column) for row, column, _ in problems(tmp_path, text, "a.yaml")] == [(1, "active")]
    (ply,) = read(tmp_path, text.replace("active: off", "active: No"), "a.yaml").plies
    assert ply == lo.Ply("010", "no", 0.1, -45.0, 2, active=False)


def test_materials_of_a_job_come_before_ones_own_and_the_library(tmp_path: Path) -> None:
    plies = [{"ply": name, "material": name, "angle_deg": 0} for name in ("a", "b", "IM7-8552-134")]
    listed = [{"material": "a", "cured_thickness_mm": 1.0}]
    (tmp_path / "job.json").write_text(json.dumps(document(plies=plies, materials=listed)))
    own = [lo.Material("a", 2.0), lo.Material("b", 4.0), lo.Material("IM7-8552-134", 8.0)]
    stack = lo.read_layup(str(tmp_path / "job.json"), materials=own)
    assert [ply.thickness for ply in stack.physical_plies()] == [1.0, 4.0, 8.0]
    with pytest.raises(lo.LayupError, match="'b' is not known"):
        lo.read_layup(str(tmp_path / "job.json"))


def test_files_that_are_not_there_or_of_another_kind(tmp_path: Path) -> None:
    with pytest.raises(lo.LayupError, match="absent.csv: found No such file"):
        lo.read_layup(str(tmp_path / "absent.csv"))
    stack = lo.layup_from_notation("[0]", "IM7-8552-134")
    for act in (lambda: lo.read_layup("layup.txt"), lambda: stack.write("layup.txt")):
        with pytest.raises(lo.LayupError, match="the ending '.txt', expected one of .csv, .json, .yaml, .yml"):
            act()
    with pytest.raises(lo.LayupError, match="file that can be written"):
        stack.write(str(tmp_path / "no folder" / "layup.csv"))
    with pytest.raises(lo.LayupError, match="found 'excel', expected one of plain, stack-up"):
        stack.write(str(tmp_path / "layup.csv"), table="excel")
    stack.write(tmp_path / "layup.csv")
    assert lo.read_layup(tmp_path / "layup.csv") == stack, "paths may be path objects"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("layup_*")), ids=lambda path: path.name)
def test_the_examples_can_be_read_and_written(path: Path, tmp_path: Path) -> None:
    stack = lo.read_layup(str(path))
    table = "stack-up" if "stack_up" in path.name else "plain"
    stack.write(str(tmp_path / path.name), table=table)
    assert lo.read_layup(str(tmp_path / path.name)) == stack


@pytest.mark.parametrize(
    "name", ["layup_symmetric_counts.csv", "layup_stack_up.csv", "layup_sandwich.yaml", "job.json"]
)
def test_damaged_files_give_one_kind_of_error(name: str, tmp_path: Path) -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    path = tmp_path / name
    if name == "job.json":
        lo.read_layup(str(EXAMPLES / "layup_sandwich.yaml")).write(str(path))
    else:
        path.write_bytes((EXAMPLES / name).read_bytes())
    whole = path.read_bytes()
    refused = 0
    for _ in range(150):
        damaged = bytearray(whole)
        for _ in range(rng.randint(1, 4)):
            place = rng.randrange(len(damaged))
            damaged[place : place + rng.randint(0, 3)] = bytes(
                rng.choice(b'\x00\xff",;:\n\t{}[]-&*!0x\xc3') for _ in range(2)
            )
        path.write_bytes(damaged)
        try:
            assert lo.read_layup(str(path)).plies
        except lo.LayupError as error:
            refused += 1
            assert str(path) in str(error), f"seed {seed}"
    assert refused > 40, f"seed {seed}"


def test_the_documentation_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    text = (ROOT / "docs" / "layup.md").read_text(encoding="utf-8")
    (tmp_path / "resources").symlink_to(ROOT / "resources")
    monkeypatch.chdir(tmp_path)
    names: Dict[str, Any] = {}
    examples = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert len(examples) >= 5
    for example in examples:
        exec(compile(example, "layup.md", "exec"), names)
    assert (tmp_path / "plies.step").exists() and len(names["laid"].plies) == 16
    assert "[45/0/±45/90/0]" in capsys.readouterr().out
    (job,) = re.findall(r"^```yaml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert read(tmp_path, job, "job.yaml").notation() == "[45_2]s"
    rows = "P1,m,1,0\nP2,m,1,4S\nP3,m,1,0\nP1,m,1,0\n"
    with pytest.raises(lo.LayupError) as caught:
        read(tmp_path, "ply,material,thickness_mm,angle_deg\n" + rows)
    assert str(caught.value).replace(str(tmp_path) + os.sep, "") in text


def test_what_the_examples_are() -> None:
    plain, counts, inactive, sandwich = (
        lo.read_layup(str(EXAMPLES / f"layup_{name}"))
        for name in ("plain.csv", "symmetric_counts.csv", "inactive_ply.csv", "sandwich.yaml")
    )
    assert plain.thickness == pytest.approx(0.199 + 4 * 0.131 + 0.125)
    angles = [ply.ply.angle for ply in counts.physical_plies()]
    assert len(angles) == 12 and angles == angles[::-1]
    assert [ply.ply.name for ply in inactive.physical_plies()] == ["P1", "P2", "Pad1", "Pad1", "P3", "P4"]
    assert sandwich.notation() == "[45_2/0/0~]s" and sandwich.thickness == pytest.approx(6 * 0.199 + 10.0)
