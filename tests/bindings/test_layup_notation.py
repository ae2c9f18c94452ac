# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shorthand of laminates: what it means, that it survives printing, and where it is wrong."""

import random
from typing import Any, List

import laminate_offset as lo
import pytest

TAGS = {"C": "IM7-8552-134", "Gl": "EGlass-7781-Epoxy"}


def angles(stack: lo.Layup) -> List[float]:
    return [ply.ply.angle for ply in stack.physical_plies()]


def read(text: str) -> lo.Layup:
    return lo.layup_from_notation(text, "CFRP", 0.125, TAGS)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("[0]", [0]),
        ("[0/45/-45/90]", [0, 45, -45, 90]),
        ("[0/45/-45/90]T", [0, 45, -45, 90]),
        ("[0/45/-45/90]s", [0, 45, -45, 90, 90, -45, 45, 0]),
        ("[0/45/-45/90]2s", [0, 45, -45, 90] * 2 + [90, -45, 45, 0] * 2),
        ("[0/45/-45/90]_2S", [0, 45, -45, 90] * 2 + [90, -45, 45, 0] * 2),
        ("[0/90]3", [0, 90] * 3),
        ("[0/90]3T", [0, 90] * 3),
        ("[(0/90)2/45]s", [0, 90, 0, 90, 45, 45, 90, 0, 90, 0]),
        ("[(0/90)_2/45~]s", [0, 90, 0, 90, 45, 90, 0, 90, 0]),
        ("[0/±45/90]", [0, 45, -45, 90]),
        ("[0/+-45/90_2]T", [0, 45, -45, 90, 90]),
        ("[∓45/-+30]", [-45, 45, -30, 30]),
        ("[(±45)2]", [45, -45, 45, -45]),
        ("[0/90_3~]s", [0, 90, 90, 90, 0]),
        ("[0/90~]2s", [0, 90, 0, 90, 0, 90, 0]),
        ("[(0/90)s/45]", [0, 90, 90, 0, 45]),
        ("[((0/90)2/45)2s]", [0, 90, 0, 90, 45] * 2 + [45, 90, 0, 90, 0] * 2),
        ("[+22.5/-22.5/.5/5.]", [22.5, -22.5, 0.5, 5]),
        (" [ 0 , 45° / −45 , 90_2 ] 2 s ", [0, 45, -45, 90, 90] * 2 + [90, 90, -45, 45, 0] * 2),
    ],
)
def test_what_shorthand_means(text: str, expected: List[float]) -> None:
    stack = read(text)
    assert angles(stack) == expected
    assert stack.thickness == 0.125 * len(expected)
    assert [ply.name for ply in stack.plies] == [f"P{index}" for index in range(1, len(stack.plies) + 1)]


def test_tags_name_materials() -> None:
    stack = lo.layup_from_notation("[0_2C/±45Gl/90C_3/30_2]s", "AS4-8552-134", tags=TAGS)
    assert [ply.material for ply in stack.plies] == [
        *["IM7-8552-134", "EGlass-7781-Epoxy", "EGlass-7781-Epoxy", "IM7-8552-134", "AS4-8552-134"]
    ]
    assert [ply.count for ply in stack.plies] == [2, 1, 1, 3, 2]
    assert [material.name for material in stack.materials] == ["IM7-8552-134", "EGlass-7781-Epoxy", "AS4-8552-134"]
    tags = {**TAGS, "A": "AS4-8552-134"}
    assert stack.notation(tags) == "[0_2C/±45Gl/90_3C/30_2A]s"
    with pytest.raises(lo.LayupError, match="found 'AS4-8552-134', expected one with a tag: IM7-8552-134, EGlass"):
        stack.notation({"C": "IM7-8552-134", "Gl": "EGlass-7781-Epoxy"})


def test_an_unknown_tag_or_material_is_refused() -> None:
    with pytest.raises(lo.LayupError, match="ply 2, tag: found 'X', expected a tag for a material: C, Gl"):
        lo.layup_from_notation("[0C/45X]", "m", 0.1, TAGS)
    with pytest.raises(lo.LayupError, match="ply 1, tag: found nothing"):
        lo.layup_from_notation("[0/45C]", tags=TAGS)
    with pytest.raises(lo.LayupError, match="'no such' is not known: one of AS4-8552-134, "):
        lo.layup_from_notation("[0]", "no such")
    own = lo.Material("mine", 0.25)
    assert lo.layup_from_notation("[0]2s", "mine", materials=[own]).thickness == 1.0


@pytest.mark.parametrize(
    "text, place, found",
    [
        ("", 1, "the end"),
        ("0/90]", 1, "'0'"),
        ("[]", 2, "']'"),
        ("[0/]", 4, "']'"),
        ("[0/x5]", 4, "'x'"),
        ("[0/90", 6, "the end"),
        ("[0/90)s", 6, "')'"),
        ("[0/(90]", 7, "']'"),
        ("[0 90]", 4, "'9'"),
        ("[0/181]", 4, "'181'"),
        ("[0_0/90]", 4, "'0'"),
        ("[0_/90]", 4, "'/'"),
        ("[0/90_1001]", 7, "'1001'"),
        ("[0/90]0s", 7, "'0'"),
        ("[0/90]s2", 8, "'2'"),
        ("[0/90]x", 7, "'x'"),
        ("[0/90]_", 8, "the end"),
        ("[0/90]99999999999999999999", 7, "'99999999999999999999'"),
        ("[0/±45_2]", 7, "'_'"),
        ("[0/±45~]s", 7, "'~'"),
        ("[±-45]", 3, "'-'"),
        ("[0/90~]", 6, "'~'"),
        ("[0~/90]s", 4, "'/'"),
        ("[(0/90~)2]s", 7, "'~'"),
        ("[0/--45]", 4, "'-'"),
        ("[0/1e3]", 4, None),
        ("[" + "(" * 30 + "0" + ")" * 30 + "]", 22, "'('"),
        ("[((0)1000)1000]", None, None),
    ],
)
def test_errors_name_the_character(text: str, place: Any, found: Any) -> None:
    with pytest.raises(lo.LayupError) as caught:
        read(text)
    (problem,) = caught.value.problems
    if found is not None:
        assert (problem.unit, problem.row, problem.found) == ("character", place, found), str(caught.value)
    assert caught.value.source == repr(text)


def random_notation(rng: random.Random, depth: int = 0) -> str:
    """Items between slashes, with groups, signs, counts and tags."""

    def item() -> str:
        kind = rng.random()
        if kind < 0.2 and depth < 3:
            return f"({random_notation(rng, depth + 1)}){rng.choice(['', '2', '_3', 's', '2s'])}"
        angle = rng.choice(["0", "45", "90", "22.5", "0.125", "179.999"])
        tag = rng.choice(["", "", "C", "Gl"])
        if kind < 0.5:
            return rng.choice(["±", "+-", "∓", "-+"]) + angle + tag
        return rng.choice(["", "-", "+"]) + angle + rng.choice([tag, tag, f"_{rng.randint(1, 12)}{tag}"])

    return rng.choice(["/", " / ", ","]).join(item() for _ in range(rng.randint(1, 4)))


def test_what_is_printed_reads_the_same() -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    tags = {**TAGS, "M": "CFRP"}
    seen = set()
    for _ in range(600):
        ending = rng.choice(["", "T", "s", "2s", "3", "2T"])
        bar = "/90~" if ending.endswith("s") and rng.random() < 0.5 else ""
        text = f"[{random_notation(rng)}{bar}]{ending}"
        stack = read(text)
        printed = stack.notation(tags)
        back = lo.layup_from_notation(printed, "", 0.125, tags)
        assert back == stack, f"seed {seed}: {text} -> {printed}"
        assert back.notation(tags) == printed, f"seed {seed}: {printed}"
        seen.add((ending, bool(bar), "±" in printed, "∓" in printed))
    assert len(seen) > 20, "the sweep has to exercise the endings and signs"


def test_any_angle_survives() -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    for _ in range(500):
        angle = rng.choice([-1, 1]) * 10.0 ** rng.uniform(-12, 2)
        stack = lo.Layup([lo.Ply("P1", "m", 1.0, angle)])
        assert read(stack.notation()).plies[0].angle == angle, f"seed {seed}"


def test_junk_gives_one_kind_of_error() -> None:
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    refused = 0
    for _ in range(3000):
        text = "".join(rng.choice("[]()/_~±∓+-0459.sT2C ,°x") for _ in range(rng.randint(0, 12)))
        try:
            read(text if rng.random() < 0.3 else f"[{text}]s")
        except lo.LayupError:
            refused += 1
    assert refused > 1000, f"seed {seed}"


def test_inactive_plies_are_not_shown() -> None:
    plies = [lo.Ply("a", "m", 1.0, 30.0), lo.Ply("b", "m", 1.0, 45.0), lo.Ply("c", "m", 1.0, 90.0, active=False)]
    assert lo.Layup(plies, symmetric=True, middle_ply=True).notation() == "[30/45]s"
    with pytest.raises(lo.LayupError, match="none that is active"):
        lo.Layup(plies[2:]).notation()
