# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random layups for the tests of layups, from a seed that a failing test shows."""

import random
from typing import Any, Callable, List, Tuple

import laminate_offset as lo
from laminate_offset.layup.fields import GRID_COLUMNS, SLENDER_COLUMNS

WORDS = ["P1", "ply 7", "Größe", "a,b", 'say "hi"', "semi;colon", "0012", "no", "null", "1e5", "#x", "a: b", "- x", "±"]


def random_thickness(rng: random.Random) -> float:
    return rng.choice([0.125, 0.1, 1.0 / 3.0, 10.0 ** rng.uniform(-6, 5), 1e-300, 1e6])


def random_angle(rng: random.Random) -> float:
    return rng.choice([0.0, 45.0, -45.0, 90.0, 22.5, -180.0, 180.0, 1e-7, rng.uniform(-180, 180)])


def unique(names: List[str]) -> List[str]:
    """The names, with a number where one comes again."""
    return [name if name not in names[:index] else f"{name} ({index})" for index, name in enumerate(names)]


def random_limits(rng: random.Random, columns: Tuple[str, ...]) -> Any:
    texts = {column: rng.choice(["", "12.5", "-3", "0"]) for column in columns}
    return {column: text for column, text in texts.items() if text}


def plain_ply(rng: random.Random, name: str) -> lo.Ply:
    """A ply that a plain table can hold, of a material of the library or of none."""
    return lo.Ply(
        name,
        rng.choice(["IM7-8552-134", "EGlass-7781-Epoxy", "unknown stuff"]),
        random_thickness(rng),
        random_angle(rng),
        rng.choice([1, 1, 2, 1000]),
        rng.choice(["", *WORDS]),
        rng.random() < 0.8,
        rng.choice(["", *WORDS]),
        rng.choice(["", *WORDS]),
        rng.choice(["", *WORDS]),
    )


def stack_up_ply(rng: random.Random, name: str, columns: Tuple[str, ...]) -> lo.Ply:
    """A ply that a stack-up table can hold."""
    limits = random_limits(rng, columns)
    group, sequence = rng.choice(["", *WORDS]), rng.choice(["", *WORDS])
    return lo.Ply(name, "AS4-8552-190", angle=random_angle(rng), group=group, sequence=sequence, limits=limits)


def random_table(rng: random.Random, kind: str) -> lo.Layup:
    """A layup that a table of this kind can hold."""
    columns = rng.choice([GRID_COLUMNS, SLENDER_COLUMNS])
    make: Callable[..., lo.Ply] = plain_ply if kind == "plain" else lambda r, n: stack_up_ply(r, n, columns)
    plies = [make(rng, name) for name in unique(rng.choices(WORDS, k=rng.randint(1, 12)))]
    library = lo.materials()
    used = dict.fromkeys(ply.material for ply in plies)
    return lo.Layup(plies, [library[name] for name in used if name in library])


def random_material(rng: random.Random, name: str) -> lo.Material:
    thickness, density = random_thickness(rng), rng.choice([None, 48.0, 1580.0])
    weight = None if density is None or thickness > 1e2 or thickness < 1e-6 else density * thickness
    return lo.Material(name, thickness, weight, density, rng.choice([None, 300.0]), rng.choice(["", *WORDS]), "source")


def random_job(rng: random.Random) -> lo.Layup:
    """A layup with every kind of field, which a document can hold."""
    materials = [random_material(rng, name) for name in unique(rng.choices(WORDS, k=rng.randint(1, 4)))]
    plies = []
    for name in unique(rng.choices(WORDS, k=rng.randint(1, 12))):
        ply = plain_ply(rng, name)
        material = rng.choice(materials).name
        thickness = rng.choice([None, ply.thickness])
        limits = random_limits(rng, rng.choice([GRID_COLUMNS, SLENDER_COLUMNS]))
        texts = (ply.boundary, ply.active, ply.rosette, ply.group, ply.sequence)
        plies.append(lo.Ply(name, material, thickness, ply.angle, ply.count, *texts, limits))
    symmetric = rng.random() < 0.5
    direction, reference = rng.choice(["normal", "reversed"]), rng.choice(["tool", "middle", "top"])
    middle = symmetric and rng.random() < 0.5
    return lo.Layup(plies, materials, rng.choice([1, 2, 1000]), symmetric, middle, direction, reference)
