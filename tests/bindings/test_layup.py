# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups: the physical sequence, its distances, what is refused, and that none of it needs FreeCAD."""

import itertools
import math
from pathlib import Path
from typing import Any, List

import laminate_offset as lo
import pytest

PACKAGE = Path(lo.__file__).parent


def layup(names: str, counts: str = "", **options: Any) -> lo.Layup:
    """A layup of plies with one-letter names; every ply has a thickness of its own: 1, 2, 4, ... mm."""
    plies = [
        lo.Ply(name, "any", 2.0**index, count=int(counts[index]) if counts else 1) for index, name in enumerate(names)
    ]
    return lo.Layup(plies, **options)


def sequence(stack: lo.Layup) -> str:
    """The rows of the physical plies by their names."""
    return "".join(ply.ply.name for ply in stack.physical_plies())


@pytest.mark.parametrize(
    "names, counts, options, expected",
    [
        ("abc", "", {}, "abc"),
        ("abc", "213", {}, "aabccc"),
        ("abc", "", {"repeat": 2}, "abcabc"),
        ("ab", "12", {"repeat": 3}, "abbabbabb"),
        ("abc", "", {"symmetric": True}, "abccba"),
        ("abc", "", {"symmetric": True, "middle_ply": True}, "abcba"),
        ("ab", "13", {"symmetric": True}, "abbbbbba"),
        ("ab", "13", {"symmetric": True, "middle_ply": True}, "abbba"),
        ("ab", "", {"symmetric": True, "repeat": 2}, "ababbaba"),
        ("ab", "", {"symmetric": True, "middle_ply": True, "repeat": 2}, "abababa"),
        ("a", "", {"symmetric": True, "middle_ply": True}, "a"),
        ("a", "2", {"symmetric": True}, "aaaa"),
    ],
)
def test_physical_sequences(names: str, counts: str, options: Any, expected: str) -> None:
    assert sequence(layup(names, counts, **options)) == expected


def test_inactive_plies_leave_no_gap() -> None:
    plies = [lo.Ply("a", "m", 1.0), lo.Ply("b", "m", 2.0, active=False), lo.Ply("c", "m", 4.0)]
    assert sequence(lo.Layup(plies, symmetric=True)) == "acca"
    assert lo.Layup(plies).physical_plies()[1].bottom == 1.0
    plies[2] = lo.Ply("c", "m", 4.0, active=False)
    assert sequence(lo.Layup(plies, symmetric=True, middle_ply=True)) == "aa", "the middle ply is not there"
    none = lo.Layup([lo.Ply("a", "m", 1.0, active=False)])
    assert none.physical_plies() == () and none.thickness == 0.0


@pytest.mark.parametrize(
    "reference, direction, expected",
    [
        ("tool", "normal", [(0, 0.5, 1), (1, 2, 3), (3, 5, 7)]),
        ("tool", "reversed", [(0, -0.5, -1), (-1, -2, -3), (-3, -5, -7)]),
        ("middle", "normal", [(-3.5, -3, -2.5), (-2.5, -1.5, -0.5), (-0.5, 1.5, 3.5)]),
        ("middle", "reversed", [(3.5, 3, 2.5), (2.5, 1.5, 0.5), (0.5, -1.5, -3.5)]),
        ("top", "normal", [(-7, -6.5, -6), (-6, -5, -4), (-4, -2, 0)]),
        ("top", "reversed", [(7, 6.5, 6), (6, 5, 4), (4, 2, 0)]),
    ],
)
def test_distances(reference: str, direction: str, expected: List[Any]) -> None:
    stack = layup("abc", reference=reference, direction=direction)
    assert [(ply.bottom, ply.middle, ply.top) for ply in stack.physical_plies()] == expected
    assert stack.thickness == 7.0


@pytest.mark.parametrize("reference, direction", itertools.product(["tool", "middle", "top"], ["normal", "reversed"]))
def test_distances_of_many_plies_are_rounded_once(reference: str, direction: str) -> None:
    plies = [lo.Ply(f"P{index}", "m", thickness, count=7) for index, thickness in enumerate([0.1, 0.131, 1.0 / 3.0])]
    stack = lo.Layup(plies, repeat=50, reference=reference, direction=direction)
    physical = stack.physical_plies()
    assert len(physical) == 3 * 7 * 50
    total = math.fsum(ply.thickness for ply in physical)
    start = {"tool": 0.0, "middle": -0.5 * total, "top": -total}[reference]
    sign = 1.0 if direction == "normal" else -1.0
    for index in (0, 1, 500, len(physical) - 1):
        ply = physical[index]
        exact = sign * math.fsum([start, *(below.thickness for below in physical[: index + 1])])
        assert ply.top == pytest.approx(exact, rel=1e-15, abs=1e-12)
        assert abs(ply.top - ply.bottom) == pytest.approx(ply.thickness, rel=1e-12)
    assert all(below.top == above.bottom for below, above in zip(physical, physical[1:])), "neighbours share a surface"
    assert stack.thickness == pytest.approx(total, rel=1e-15)
    assert physical[0 if reference == "tool" else -1].bottom == 0.0 or reference != "tool"
    assert physical[-1].top == 0.0 or reference != "top"


def test_physical_plies_have_names_and_numbers_of_their_own() -> None:
    plies = [lo.Ply("a", "m", 1.0, count=3), lo.Ply("a.2", "m", 1.0)]
    physical = lo.Layup(plies, symmetric=True).physical_plies()
    assert [ply.number for ply in physical] == list(range(1, 9))
    assert [ply.name for ply in physical] == ["a", "a.3", "a.4", "a.2", "a.2.2", "a.5", "a.6", "a.7"]


def test_a_flattened_layup_is_the_same_stack() -> None:
    stack = layup("abc", "213", symmetric=True, middle_ply=True, repeat=2, reference="middle", direction="reversed")
    flat = stack.flattened()
    assert (flat.repeat, flat.symmetric, flat.middle_ply) == (1, False, False)
    assert len(flat.plies) == len(flat.physical_plies()) == len(stack.physical_plies())
    for one, other in zip(stack.physical_plies(), flat.physical_plies()):
        assert (one.name, one.bottom, one.top) == (other.name, other.bottom, other.top)


def test_thickness_comes_from_the_ply_or_its_material() -> None:
    cured = lo.Material("m", 0.131)
    stack = lo.Layup([lo.Ply("a", "m"), lo.Ply("b", "m", 0.2), lo.Ply("c", "other", 0.3)], [cured])
    assert [ply.thickness for ply in stack.physical_plies()] == [0.131, 0.2, 0.3]
    assert stack.material("m") is cured
    with pytest.raises(lo.LayupError, match="found 'other', expected one of m"):
        stack.material("other")


@pytest.mark.parametrize("name", ["angle", "thickness", "count", "active", "name", "material", "boundary", "limits"])
def test_a_ply_refuses_what_is_out_of_range(name: str) -> None:
    bad = {
        "angle": [180.1, -181, math.nan, math.inf, "x", "1_0", True, None, 10**400],
        "thickness": [0.0, -1.0, 1e7, math.nan, "thin", False],
        "count": [0, -1, 1001, 1.5, "2.0", "1_0", True],
        "active": ["maybe", 2, 0.5],
        "name": ["", " ", None, 5, "a\nb", "\ud800"],
        "material": ["", None],
        "boundary": [3, "a\tb"],
        "limits": [{"Other": "1"}, {"Offset": "far"}, {"Limit 1": "a", "End Plane": "b"}, 5],
    }[name]
    good = {"name": "a", "material": "m", "thickness": 1.0}
    for value in bad:
        with pytest.raises(lo.LayupError) as caught:
            lo.Ply(**{**good, name: value})
        assert [problem.column for problem in caught.value.problems] == [name], value
        assert isinstance(caught.value, ValueError)


def test_a_ply_takes_what_means_the_same() -> None:
    ply = lo.Ply(
        " a ", "m", "0.5", "+45", "2", active="No", limits={"Offset": "5", "Starting Plane": "", "End Plane": "S"}
    )
    assert ply == lo.Ply("a", "m", 0.5, 45.0, 2, active=False, limits=(("End Plane", "S"), ("Offset", "5")))
    numpy = pytest.importorskip("numpy")
    ply = lo.Ply("a", "m", numpy.float32(0.5), numpy.float64(45.0), numpy.int64(2))
    assert (type(ply.thickness), type(ply.angle), type(ply.count)) == (float, float, int)


def test_a_layup_names_all_that_is_wrong_with_it() -> None:
    plies = [lo.Ply("a", "m"), lo.Ply("a", "unknown"), lo.Ply("b", "m", 1.0)]
    with pytest.raises(lo.LayupError) as caught:
        lo.Layup(plies, [lo.Material("m"), lo.Material("m", 0.1)], repeat=0, direction="up", reference="mid")
    places = [problem.place for problem in caught.value.problems]
    assert places[:3] == ["repeat", "direction", "reference"]
    assert places[3:] == ["material 2, name", "ply 2, name", "ply 2, thickness"]
    assert "found 'up', expected normal or reversed" in str(caught.value)
    with pytest.raises(lo.LayupError, match="at least one ply"):
        lo.Layup([])
    with pytest.raises(lo.LayupError, match="middle_ply"):
        lo.Layup([lo.Ply("a", "m", 1.0)], middle_ply=True)


def test_a_material_refuses_weights_that_contradict_each_other() -> None:
    assert lo.Material("m", 0.13, 206.2, 1580.0).areal_weight == 206.2
    assert lo.Material("m", 0.1, 104.9, 1000.0).density == 1000.0
    with pytest.raises(lo.LayupError, match="fibres and resin together"):
        lo.Material("m", 0.13, 134.0, 1580.0)
    for field in ("cured_thickness", "areal_weight", "density", "roll_width"):
        for value in (0.0, -1.0, math.nan, 1e9):
            with pytest.raises(lo.LayupError, match=field):
                lo.Material("m", **{field: value})


def test_layups_do_not_need_freecad(python: Any) -> None:
    code = (
        "import sys, types; package = types.ModuleType('laminate_offset'); package.__path__ = [sys.argv[0]]\n"
        f"package.__path__ = [{str(PACKAGE)!r}]; sys.modules['laminate_offset'] = package\n"
        "from laminate_offset import layup\n"
        "stack = layup.layup_from_notation('[0/90]s', 'IM7-8552-134')\n"
        "assert not {'FreeCAD', 'Part', 'laminate_offset._core'} & set(sys.modules)\n"
        "print(stack.notation(), stack.thickness)"
    )
    run = python(code)
    assert run.stdout == "[0/90]s 0.524\n", run.stderr
