# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a deviation map looks: the offset in colours, and a legend at the left of the view."""

from typing import Any, Sequence

from ..legend import Colour
from ..texts import translate
from .colour_map import ColourMapViewProvider, Scale

#: From the most negative deviation through none to the most positive one.
_COLOURS: Sequence[Colour] = (
    (0.13, 0.31, 0.70),
    (0.55, 0.73, 0.90),
    (0.97, 0.97, 0.94),
    (0.96, 0.65, 0.48),
    (0.73, 0.10, 0.16),
)


class DeviationMapViewProvider(ColourMapViewProvider):
    """Proxy of the view provider."""

    ICON = "LaminateOffset_DeviationMap"
    PANEL = "deviation_map"
    DRAWN = ("Deviations",)

    def shares(self, obj: Any) -> Sequence[float]:
        """None is in the middle; the extreme deviation is at one of the ends."""
        extreme = _extreme(obj)
        return [0.5 + 0.5 * value / extreme for value in _values(obj)]

    def scale(self, obj: Any) -> Scale:
        """Deviations in mm."""
        extreme = _extreme(obj)
        ticks = [f"{extreme:.3g} mm", f"{extreme / 2:.3g}", "0", f"{-extreme / 2:.3g}", f"{-extreme:.3g} mm"]
        return Scale(translate("LaminateOffset", "Deviation"), ticks, _COLOURS)


def _values(obj: Any) -> Sequence[float]:
    return obj.Deviations if hasattr(obj, "Deviations") else []


def _extreme(obj: Any) -> float:
    return max(map(abs, _values(obj)), default=1.0) or 1.0
