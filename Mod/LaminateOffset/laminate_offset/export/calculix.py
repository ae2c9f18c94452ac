# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stack as the section of a shell in CalculiX: *ORIENTATION and *SHELL SECTION, COMPOSITE.

CalculiX stacks the layers along the normal of the shell elements, and projects an orientation's first axis onto each
element: on a curved surface that is not quite the ply's angle from the projected first axis. Only S8R and S6 elements
may have a composite section.
"""

import math
import os
import re
from typing import TYPE_CHECKING, Dict, Iterable, List, Optional

from ..layup import LayupError, PhysicalPly
from ..layup.text_files import write_text
from ..replacing import FileError
from ..rosette import Rosette, check_one_rosette
from .fibres import ONE_ROSETTE, Axes, axes_of

if TYPE_CHECKING:
    from ..stack import PlyStack

# The longest name that CalculiX keeps.
NAME_LENGTH = 80
# Density in t/mm3, which goes with mm, N and MPa.
TONNES = 1e-12


def export_calculix(
    stack: "PlyStack", path: str, element_set: str = "EPLIES", rosette: Optional[Rosette] = None
) -> None:
    """Writes the stack as text to be included in a CalculiX input file (*INCLUDE), in mm, N and MPa.

    The elements lie on the lay-up surface, with their normals along its outward normal. The layers come in the order in
    which CalculiX stacks them, along that normal; OFFSET says where the lay-up surface lies in the stack. The materials'
    elastic constants are not part of a layup: the text names the *MATERIALs that the input file has to define first.

    Args:
        element_set: the set of S8R or S6 elements that gets the section.
        rosette: the axes that the plies' angles refer to. None: the model's x axis on the middle of the surface, or the
            y axis where x stands too steeply on it; or the first axis of the model that stands nowhere on the face.

    Raises:
        FileError: the file cannot be written.
        ValueError: element_set is no name that CalculiX takes, or a ply has a boundary: one section is the same on all of
            its elements; or rows of the layup name different rosettes.
        TypeError: rosette is no Rosette.
    """
    check_section(ply.ply for ply in stack.plies)
    path = os.fspath(path)
    if names([element_set])[element_set] != element_set.upper():
        raise ValueError(f"element_set must be letters, digits, - and _, at most {NAME_LENGTH}; it is {element_set!r}.")
    try:
        write_text(path, calculix_text(stack, element_set, axes_of(stack, rosette)))
    except LayupError as error:
        raise FileError(str(error)) from error


def check_section(plies: Iterable[PhysicalPly]) -> None:
    """Raises ValueError for plies that one section cannot hold."""
    plies = tuple(plies)
    bounded = [ply.name for ply in plies if ply.ply.boundary]
    if bounded:
        raise ValueError(
            f"A section is the same on all of its elements; {', '.join(bounded)} cover parts of the face only."
        )
    check_one_rosette(plies, ONE_ROSETTE)


def calculix_text(stack: "PlyStack", element_set: str, axes: Axes) -> str:
    """The text that export_calculix writes."""
    plies = sorted((ply.ply for ply in stack.plies), key=lambda ply: ply.middle)
    low = min(min(ply.bottom, ply.top) for ply in plies)
    thickness = sum(ply.thickness for ply in plies)
    materials = names(ply.ply.material for ply in plies)
    orientations = names((f"ANGLE {ply.ply.angle:g}" for ply in plies))
    lines = _head(stack, materials)
    for angle in dict.fromkeys(ply.ply.angle for ply in plies):
        lines += _orientation(orientations[f"ANGLE {angle:g}"], axes, angle)
    # The lay-up surface, where the nodes are, counts from the middle of the stack in units of its thickness.
    offset = _number(-(low + 0.5 * thickness) / thickness)
    lines.append(f"*SHELL SECTION, COMPOSITE, ELSET={element_set.upper()}, OFFSET={offset}")
    for ply in plies:
        lines.append(f"** {ply.number} {_comment(ply.name)}")
        lines.append(
            f"{_number(ply.thickness)}, , {materials[ply.ply.material]}, {orientations[f'ANGLE {ply.ply.angle:g}']}"
        )
    return "\n".join(lines) + "\n"


def names(texts: Iterable[str]) -> Dict[str, str]:
    """A name for every text that CalculiX takes and that no other text has: capitals, digits, - and _."""
    found: Dict[str, str] = {}
    for text in dict.fromkeys(texts):
        plain = re.sub(r"[^A-Z0-9_-]", "_", text.upper())[: NAME_LENGTH - 4] or "_"
        candidates = [plain, *(f"{plain}_{number}" for number in range(2, 1000))]
        found[text] = next(name for name in candidates if name not in found.values())
    return found


def _head(stack: "PlyStack", materials: Dict[str, str]) -> List[str]:
    lines = [
        f"** {len(stack.plies)} plies, {stack.report['thickness']:g} mm, written by LaminateOffset; mm, N, MPa",
        "** S8R or S6 elements on the lay-up surface, their normals along its outward normal.",
        "** Layers in the order in which CalculiX stacks them, along that normal.",
        "** Define before this text, with elastic constants:",
    ]
    for text, name in materials.items():
        density = _density(stack, text)
        more = "" if density is None else f", *DENSITY {_number(density)} t/mm3"
        lines.append(f"**   *MATERIAL, NAME={name}{more}")
    return lines


def _density(stack: "PlyStack", material: str) -> Optional[float]:
    for known in stack.layup.materials:
        if known.name == material and known.density is not None:
            return known.density * TONNES
    return None


def _orientation(name: str, axes: Axes, angle: float) -> List[str]:
    """The axes turned by the angle about their normal."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    first, second = cosine * axes.first + sine * axes.second, cosine * axes.second - sine * axes.first
    numbers = ", ".join(_number(value) for value in (*first, *second))
    return [f"*ORIENTATION, NAME={name}, SYSTEM=RECTANGULAR", numbers]


def _number(value: float) -> str:
    """At most 20 characters, which is what CalculiX reads of a number."""
    return f"{round(value, 12) + 0.0:.12g}"


def _comment(text: str) -> str:
    return " ".join(text.split())
