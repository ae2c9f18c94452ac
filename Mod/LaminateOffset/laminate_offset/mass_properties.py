# SPDX-License-Identifier: LGPL-2.1-or-later
"""Areas, volumes, masses and centres of gravity of a ply stack, from integrals over the lay-up face, without a mesh."""

from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

import FreeCAD

from . import _core
from .layup import Layup, LayupError, Material, PhysicalPly

KILOGRAMS_BY_DENSITY = 1e-9  # in kg/m3 times mm3
KILOGRAMS_BY_AREAL_WEIGHT = 1e-9  # in g/m2 times mm2


@dataclass(frozen=True)
class PlyProperties:
    """Figures of one ply.

    Attributes:
        number, name, material: those of the ply.
        thickness: in mm.
        area: in mm2, of its true middle surface, half way between bottom and top.
        volume: in mm3, between bottom and top.
        mass: in kg: density times volume; where the material has no density, areal weight times area; None where it has
            neither.
        center: centre of gravity in mm.
    """

    number: int
    name: str
    material: str
    thickness: float
    area: float
    volume: float
    mass: Optional[float]
    center: "FreeCAD.Vector"


@dataclass(frozen=True)
class MaterialTotal:
    """All plies of one material.

    Attributes:
        material: its name.
        plies: how many there are.
        area: in mm2, of all their middle surfaces.
        volume: in mm3.
        mass: in kg, or None.
        roll_length: length in mm of a roll of the material's width that has this area, offcuts not counted; None where
            the roll width is not known.
    """

    material: str
    plies: int
    area: float
    volume: float
    mass: Optional[float]
    roll_length: Optional[float]


@dataclass(frozen=True)
class MassProperties:
    """Figures of a whole stack.

    Attributes:
        plies: a PlyProperties for every ply, from the tool outwards.
        materials: a MaterialTotal for every material, in the order of first use.
        area: of all plies in mm2.
        volume: in mm3.
        mass: in kg; None where that of a ply is not known.
        center: centre of gravity in mm, by mass; by volume where a mass is not known.
        thickness: of all plies in mm.
        relative_error: the estimated error of the integrals, relative to their size; not a proven bound.
    """

    plies: Tuple[PlyProperties, ...]
    materials: Tuple[MaterialTotal, ...]
    area: float
    volume: float
    mass: Optional[float]
    center: "FreeCAD.Vector"
    thickness: float
    relative_error: float

    def to_dict(self) -> Dict[str, Any]:
        """The figures as plain values, for JSON."""
        values = {**vars(self), "center": list(self.center)}
        values["plies"] = [{**vars(ply), "center": list(ply.center)} for ply in self.plies]
        values["materials"] = [dict(vars(material)) for material in self.materials]
        return values


def measure(layup: Layup, face: Any, plies: Sequence[PhysicalPly]) -> MassProperties:
    """The figures of plies that lie between two constant distances of a face each.

    Args:
        layup: knows the materials.
        face: the lay-up face; all plies share one quadrature over it.
        plies: from the tool outwards.
    """
    intervals = [(min(ply.bottom, ply.top), max(ply.bottom, ply.top)) for ply in plies]
    values = _core.face_integrals(face, [ply.middle for ply in plies], intervals)
    found = zip(plies, values["areas"], values["volumes"], values["moments"])
    measured = [_properties(layup, ply, area, volume, moment) for ply, area, volume, moment in found]
    return _totals(layup, tuple(measured), values["relative_error"])


def measure_partial(layup: Layup, plies: Sequence[Tuple[PhysicalPly, Any, Any]]) -> MassProperties:
    """The figures of plies that cover parts of a face at distances that vary over ramps.

    Args:
        layup: knows the materials.
        plies: each ply with the part of the lay-up face that it covers and its LaidLayer, from the tool outwards; plies
            with the same Part.Face at constant distances share one quadrature.
    """
    errors: List[float] = []
    found: Dict[int, PlyProperties] = {}
    groups: Dict[int, List[Tuple[PhysicalPly, Any, Any]]] = {}
    for laid in plies:
        groups.setdefault(id(laid[1]), []).append(laid)
    for members in groups.values():
        figures = _core.ply_integrals(members[0][1], [layer for _, _, layer in members])
        for (ply, _, _), values in zip(members, figures):
            found[ply.number] = _properties(layup, ply, values["area"], values["volume"], values["moment"])
            errors.append(values["relative_error"])
    return _totals(layup, tuple(found[ply.number] for ply, _, _ in plies), max(errors))


def known_material(layup: Layup, name: str) -> Optional[Material]:
    """The layup's material of that name, or None."""
    try:
        return layup.material(name)
    except LayupError:
        return None


def _properties(
    layup: Layup, ply: PhysicalPly, area: float, volume: float, moment: Tuple[float, float, float]
) -> PlyProperties:
    mass = _mass(known_material(layup, ply.ply.material), area, volume)
    center = FreeCAD.Vector(*moment) * (1.0 / volume)
    return PlyProperties(ply.number, ply.name, ply.ply.material, ply.thickness, area, volume, mass, center)


def _mass(material: Optional[Material], area: float, volume: float) -> Optional[float]:
    if material is not None and material.density is not None:
        return KILOGRAMS_BY_DENSITY * material.density * volume
    if material is not None and material.areal_weight is not None:
        return KILOGRAMS_BY_AREAL_WEIGHT * material.areal_weight * area
    return None


def _sum(masses: Iterable[Optional[float]]) -> Optional[float]:
    known = list(masses)
    return None if any(mass is None for mass in known) else float(sum(mass for mass in known if mass is not None))


def _totals(layup: Layup, plies: Tuple[PlyProperties, ...], relative_error: float) -> MassProperties:
    mass = _sum(ply.mass for ply in plies)
    volume = sum(ply.volume for ply in plies)
    center = FreeCAD.Vector()
    for ply in plies:
        share = ply.volume / volume if not mass or ply.mass is None else ply.mass / mass
        center += ply.center * share
    return MassProperties(
        plies,
        _materials(layup, plies),
        sum(ply.area for ply in plies),
        volume,
        mass,
        center,
        sum(ply.thickness for ply in plies),
        relative_error,
    )


def _materials(layup: Layup, plies: Sequence[PlyProperties]) -> Tuple[MaterialTotal, ...]:
    totals = []
    for name in dict.fromkeys(ply.material for ply in plies):
        members = [ply for ply in plies if ply.material == name]
        material = known_material(layup, name)
        area = sum(ply.area for ply in members)
        width = None if material is None else material.roll_width
        totals.append(
            MaterialTotal(
                name,
                len(members),
                area,
                sum(ply.volume for ply in members),
                _sum(ply.mass for ply in members),
                None if width is None else area / width,
            )
        )
    return tuple(totals)
