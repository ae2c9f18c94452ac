# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials, plies and layups. Lengths are in mm, angles in degrees, areal weights in g/m2, densities in kg/m3."""

from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import accumulate
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple

from .errors import LayupError, Problem, quoted
from .fields import LAYUP_FIELDS, MATERIAL_FIELDS, PLY_FIELDS, Field

# By how much areal weight and density times thickness may differ, relative to the larger. Data sheets round the
# thickness to some 0.5 % and the density to 0.3 %; the weight of the fibres alone is 30 % less or more.
WEIGHT_MARGIN = 0.05


@dataclass(frozen=True)
class Material:
    """What a ply is made of.

    Attributes:
        name: what plies call it.
        cured_thickness: of one cured ply, in mm, above 0; None: every ply states its own.
        areal_weight: mass of one cured ply per area, fibres and resin together, in g/m2, above 0; or None.
        density: of the cured ply in kg/m3, above 0; or None.
        roll_width: in mm, above 0; or None.
        description: a line for people.
        source: where the figures come from.

    Raises:
        LayupError: a value is out of its range, or areal_weight differs from cured_thickness * density by more than
            5 %: mass would depend on which of them is used.
    """

    name: str
    cured_thickness: Optional[float] = None
    areal_weight: Optional[float] = None
    density: Optional[float] = None
    roll_width: Optional[float] = None
    description: str = ""
    source: str = ""

    def __post_init__(self) -> None:
        problems = _normalise(self, MATERIAL_FIELDS, "material")
        if not problems:
            problems = self._weight_problems()
        if problems:
            raise LayupError(f"material {quoted(self.name)}", problems)

    def _weight_problems(self) -> List[Problem]:
        if self.cured_thickness is None or self.density is None or self.areal_weight is None:
            return []
        weight = self.cured_thickness * self.density  # mm * kg/m3 = g/m2
        if abs(weight - self.areal_weight) <= WEIGHT_MARGIN * max(weight, self.areal_weight):
            return []
        expected = f"thickness * density = {weight:.4g} g/m2 within {WEIGHT_MARGIN:.0%} (fibres and resin together)"
        return [Problem("areal_weight", f"{self.areal_weight:g}", expected, unit="material")]


@dataclass(frozen=True)
class Ply:
    """One row of a layup table: a ply, or several equal ones on top of each other.

    Attributes:
        name: the ply's own name within its layup.
        material: the name of its material.
        thickness: of one cured ply in mm, above 0; None: the material's cured thickness.
        angle: of the fibres (of a fabric, of the warp) in degrees from -180 to 180, from the rosette's first axis
            towards its second one.
        count: how often the ply follows itself, from 1 to 1000.
        boundary: the name of the closed curve or sketch that bounds it; "": the whole face.
        active: False takes it out of the stack, without a gap.
        rosette: the name of the rosette that its angle refers to; "": the layup's own.
        group: the plies group of a stack-up file; "": none.
        sequence: the sequence of a stack-up file; "": none.
        limits: grid limits of a stack-up file, as (column, text) in the file's order; a mapping is taken, too.

    Raises:
        LayupError: a value is out of its range.
    """

    name: str
    material: str
    thickness: Optional[float] = None
    angle: float = 0.0
    count: int = 1
    boundary: str = ""
    active: bool = True
    rosette: str = ""
    group: str = ""
    sequence: str = ""
    limits: Tuple[Tuple[str, str], ...] = ()

    def __post_init__(self) -> None:
        problems = _normalise(self, PLY_FIELDS, "ply")
        if problems:
            raise LayupError(f"ply {quoted(self.name)}", problems)


@dataclass(frozen=True)
class PhysicalPly:
    """One ply of the finished stack.

    The distances are those from the lay-up surface where every active ply is present, in mm, signed along the face's
    outward normal. Bottom is the side towards the tool: with draping direction "reversed" it is the larger distance.

    Attributes:
        number: from 1, outwards from the tool.
        name: the row's name; later copies are called "NAME.2", "NAME.3" and so on.
        ply: the row of the layup that it comes from.
        thickness: in mm, above 0.
        bottom: signed distance of the side towards the tool.
        middle: signed distance of the surface half way between.
        top: signed distance of the side away from the tool.
    """

    number: int
    name: str
    ply: Ply
    thickness: float
    bottom: float
    middle: float
    top: float


@dataclass(frozen=True)
class Layup:
    """A stack of plies on a lay-up surface.

    The plies, inactive ones left out, each `count` times, are laid `repeat` times from the tool outwards; where the
    layup is symmetric their mirror image follows.

    Attributes:
        plies: the rows, from the tool surface outwards; at least one, each with a name of its own.
        materials: what the plies are made of, each with a name of its own. A ply that states its thickness may name a
            material that is not here.
        repeat: how often the rows are laid, from 1 to 1000, before they are mirrored.
        symmetric: whether the mirror image follows.
        middle_ply: the plane of symmetry lies in the middle of the last row: its last occurrence is not mirrored. Only
            with symmetric.
        direction: draping direction: "normal" stacks along the face's outward normal, "reversed" against it.
        reference: the surface of the stack that lies on the face: "tool" (the first ply's bottom), "middle" (half of
            the thickness) or "top" (the last ply's top).

    Raises:
        LayupError: names every value that is out of its range, every name given twice and every ply without thickness.
    """

    plies: Tuple[Ply, ...]
    materials: Tuple[Material, ...] = ()
    repeat: int = 1
    symmetric: bool = False
    middle_ply: bool = False
    direction: str = "normal"
    reference: str = "tool"

    def __post_init__(self) -> None:
        object.__setattr__(self, "plies", tuple(self.plies))
        object.__setattr__(self, "materials", tuple(self.materials))
        problems = _normalise(self, LAYUP_FIELDS, "layup")
        problems += layup_problems(self.plies, self.materials)
        if not problems and self.middle_ply and not self.symmetric:
            problems.append(Problem("middle_ply", "'yes'", "no, where symmetric is not set", unit="layup"))
        if problems:
            raise LayupError("layup", problems)

    @property
    def thickness(self) -> float:
        """Thickness in mm where every active ply is present; 0 when none is active."""
        return float(sum(Fraction(self.ply_thickness(ply)) for ply in self._sequence()))

    def ply_thickness(self, ply: Ply) -> float:
        """Thickness of one ply of a row in mm: its own, or the cured thickness of its material."""
        if ply.thickness is not None:
            return ply.thickness
        thickness = self.material(ply.material).cured_thickness
        assert thickness is not None  # checked when the layup was made
        return thickness

    def material(self, name: str) -> Material:
        """The material of that name. Raises LayupError when the layup has none."""
        for material in self.materials:
            if material.name == name:
                return material
        raise LayupError("layup", [Problem("material", quoted(name), _one_of(self.materials), unit="layup")])

    def physical_plies(self) -> Tuple[PhysicalPly, ...]:
        """The finished stack, ply by ply from the tool outwards, with the distances from the lay-up surface."""
        sequence = self._sequence()
        thicknesses = [self.ply_thickness(ply) for ply in sequence]
        levels = self._levels(thicknesses)
        names = _physical_names(sequence, {ply.name for ply in self.plies})
        return tuple(
            PhysicalPly(index + 1, names[index], ply, thicknesses[index], bottom, 0.5 * (bottom + top), top)
            for index, (ply, bottom, top) in enumerate(zip(sequence, levels, levels[1:]))
        )

    def flattened(self) -> "Layup":
        """The same stack with one row for every physical ply: no counts, repetition, symmetry or inactive rows.

        Raises LayupError when no ply is active.
        """
        rows = tuple(replace(ply.ply, name=ply.name, count=1) for ply in self.physical_plies())
        return replace(self, plies=rows, repeat=1, symmetric=False, middle_ply=False)

    def notation(self, tags: Optional[Mapping[str, str]] = None) -> str:
        """Shorthand such as "[0/±45/90]2s", which layup_from_notation reads.

        Angles, counts, repetition and symmetry are shown; thicknesses, boundaries and inactive plies are not.

        Args:
            tags: the letters that stand for materials, e.g. {"C": "IM7-8552-134"}; None shows no materials.

        Raises:
            LayupError: no ply is active, or a material has no tag.
        """
        from .notation import print_notation

        return print_notation(self, tags)

    def write(self, path: str, table: str = "plain") -> None:
        """Writes the layup; replaces a file in one step.

        Args:
            path: the name's ending decides: .csv is a table, .json, .yaml and .yml hold the whole job.
            table: the columns of a table: "plain" (ply, material, thickness_mm, ...) or "stack-up" (those of a
                3DEXPERIENCE-style file: Plies Group, Sequence, Ply, Material, Orientation, ...).

        Raises:
            LayupError: the ending is not known, the file cannot be written, or a table would not hold everything:
                it has no place for repetition, symmetry, direction, reference and materials of one's own.
        """
        from .files import write_layup

        write_layup(self, path, table)

    def _sequence(self) -> List[Ply]:
        """The plies of the finished stack, from the tool outwards."""
        half = [ply for ply in self.plies if ply.active for _ in range(ply.count)] * self.repeat
        if not self.symmetric:
            return half
        last = self.plies[-1]
        shared = last.count if self.middle_ply and last.active else 0
        return half + half[: len(half) - shared][::-1]

    def _levels(self, thicknesses: Sequence[float]) -> List[float]:
        """Signed distances of the first bottom and of every top from the lay-up surface, each rounded only once."""
        exact = [Fraction(thickness) for thickness in thicknesses]
        total = sum(exact, Fraction(0))
        start = {"tool": Fraction(0), "middle": -total / 2, "top": -total}[self.reference]
        sign = 1 if self.direction == "normal" else -1
        return [float(sign * height) for height in accumulate(exact, initial=start)]


def checked_layup(source: str, plies: Sequence[Ply], known: Mapping[str, Material], **options: Any) -> Layup:
    """The layup of these plies and of those known materials that they use; a LayupError names the source."""
    problems = layup_problems(plies, tuple(known.values()))
    if problems:
        raise LayupError(source, problems)
    return Layup(tuple(plies), used_materials(plies, known), **options)


def used_materials(plies: Iterable[Ply], known: Mapping[str, Material]) -> Tuple[Material, ...]:
    """The known ones among the materials of these plies, in the order of their first use."""
    names = dict.fromkeys(ply.material for ply in plies)
    return tuple(known[name] for name in names if name in known)


def layup_problems(plies: Sequence[Ply], materials: Sequence[Material]) -> List[Problem]:
    """What is wrong with plies and materials together; rows count from 1 in their lists."""
    problems = [] if plies else [Problem("plies", "none", "at least one ply", unit="layup")]
    problems += _repeated_names([material.name for material in materials], "material")
    problems += _repeated_names([ply.name for ply in plies], "ply")
    cured = {material.name: material.cured_thickness for material in materials}
    for row, ply in enumerate(plies, start=1):
        if ply.thickness is None and cured.get(ply.material) is None:
            problems.append(Problem("thickness", "nothing", _missing_thickness(ply, materials), row, "ply"))
    return problems


def _missing_thickness(ply: Ply, materials: Sequence[Material]) -> str:
    needed = "a number of mm above 0"
    if any(material.name == ply.material for material in materials):
        return f"{needed}, since material '{ply.material}' has no cured thickness"
    return f"{needed}, or a material with a cured thickness; '{ply.material}' is not known: {_one_of(materials)}"


def _one_of(materials: Iterable[Material]) -> str:
    names = ", ".join(material.name for material in materials)
    return f"one of {names}" if names else "there are no materials"


def _repeated_names(names: Sequence[str], unit: str) -> List[Problem]:
    seen: Set[str] = set()
    problems = []
    for row, name in enumerate(names, start=1):
        if name in seen:
            problems.append(Problem("name", quoted(name), f"a name that no {unit} before it has", row, unit))
        seen.add(name)
    return problems


def _normalise(thing: Any, rules: Iterable[Field], unit: str) -> List[Problem]:
    """Replaces every field by its parsed value; returns what is wrong."""
    problems = []
    for rule in rules:
        value = getattr(thing, rule.name)
        try:
            object.__setattr__(thing, rule.name, rule.parse(value))
        except (TypeError, ValueError, OverflowError):
            problems.append(Problem(rule.name, quoted(value), rule.expected, unit=unit))
    return problems


def _physical_names(sequence: Iterable[Ply], taken: Iterable[str]) -> List[str]:
    """A name for every physical ply that no other has: a copy's number is appended, past names that are taken."""
    used = set(taken)
    copies: Dict[str, Iterator[int]] = {}
    names = []
    for ply in sequence:
        name = ply.name
        if ply.name in copies:
            name = next(name for name in (f"{ply.name}.{copy}" for copy in copies[ply.name]) if name not in used)
        else:
            copies[ply.name] = iter(range(2, 2**31))
        used.add(name)
        names.append(name)
    return names
