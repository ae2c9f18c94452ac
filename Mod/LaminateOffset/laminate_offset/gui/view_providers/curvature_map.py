# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a curvature map looks: the faces in colours, and a legend at the left of the view."""

from typing import Any, Sequence

from ...features.curvature_map import SHOWN, shown_values
from ..legend import Colour
from ..texts import translate
from .colour_map import ColourMapViewProvider, Scale

#: From no limit to the limit in steps of a quarter, and a colour that stands out for what folds.
_COLOURS: Sequence[Colour] = (
    (0.19, 0.36, 0.68),
    (0.30, 0.66, 0.72),
    (0.78, 0.88, 0.52),
    (0.98, 0.72, 0.25),
    (0.82, 0.15, 0.12),
    (0.30, 0.02, 0.22),
)
_TOP = 1.25
_STEPS = (1.0, 0.75, 0.5, 0.25)


class CurvatureMapViewProvider(ColourMapViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_CurvatureMap"
    PANEL = "curvature_map"
    DRAWN = ("Highest", "Shows")

    def shares(self, obj: Any) -> Sequence[float]:
        """The use of the limit, or the curvature over the largest one."""
        if not hasattr(obj, "Highest") or len(obj.Lowest) != len(obj.Highest):
            return []
        values = shown_values(obj)
        return values / _TOP if obj.Shows == SHOWN[0] else values / _largest(values)

    def scale(self, obj: Any) -> Scale:
        """Percents of the limit, or limits in mm."""
        if obj.Shows == SHOWN[0]:
            folds = translate("LaminateOffset", "folds")
            return Scale(f"{obj.Distance.Value:.4g} mm", [folds, "100 %", "75 %", "50 %", "25 %", "0 %"], _COLOURS)
        largest = max(shown_values(obj))
        outwards, inwards = translate("LaminateOffset", "Limit outwards"), translate("LaminateOffset", "Limit inwards")
        title = outwards if obj.Shows == SHOWN[1] else inwards
        ticks = [f"{1.0 / (step * largest):.4g} mm" if largest > 0 else "" for step in _STEPS]
        return Scale(title, [*ticks, translate("LaminateOffset", "any")], _COLOURS[:-1])


def _largest(values: Any) -> float:
    return float(max(values)) or 1.0
