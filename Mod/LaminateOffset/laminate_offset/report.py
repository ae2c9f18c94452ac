# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of one face, as the engine gives it and as it is stored in JSON."""

import copy
import json
from typing import Any, Dict, Iterator, List, Mapping


class Fields(Mapping[str, Any]):
    """Read-only named values, as keys and as attributes: fields["poles_u"] and fields.poles_u are the same."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values: Dict[str, Any] = copy.deepcopy(dict(values))

    def __getitem__(self, key: str) -> Any:
        value = self._values[key]
        return Fields(value) if isinstance(value, dict) else copy.deepcopy(value)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __getattr__(self, name: str) -> Any:
        # Underscored names are never fields; asking for them first keeps copying and pickling from recursing.
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"{type(self).__name__} has no field '{name}'")
        return self[name]

    def __dir__(self) -> Iterator[str]:
        yield from super().__dir__()
        yield from self._values

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._values!r})"

    def to_dict(self) -> Dict[str, Any]:
        """The values as plain dicts, lists, numbers and strings; a copy."""
        return copy.deepcopy(self._values)


class ExtensionReport(Fields):
    """How one face was extended past its sides, with measured figures.

    Every field of the JSON format is an attribute: status, stage, message, where, length, continuity, rule, sides,
    surface, elapsed_ms. sides is a list of {"side", "parameter", "mean_length", "shortest", "longest", "join_angle",
    "moved_edges"} in the order in which they were extended: where the surface ends now, the arc lengths of eight
    iso-curves of the extension in mm, the largest angle in radians seen between their tangents on both sides of the
    join, and how many edges moved outwards.
    """

    def to_json(self) -> str:
        """The report as indented JSON text."""
        return json.dumps(self._values, indent=2, ensure_ascii=False)

    def summary(self) -> str:
        """One line for a person: the sides with their lengths."""
        sides = ", ".join(
            "{side} {mean_length:.6g} mm ({shortest:.6g} to {longest:.6g})".format(**side) for side in self.sides
        )
        return f"extended by {self.length:.6g} mm: {sides}"


class OffsetReport(Fields):
    """What was done to one face, with measured and proven figures.

    Every field of the JSON format is an attribute: status, stage, message, where, method, distance, tolerance,
    certified_error, sampled_error, edge_error, surface, limits, limits_proven, self_intersection, extension, loops,
    edges, faces, gap, crease, elapsed_ms. Lengths are in mm, times in ms; distance and limits are signed along the base
    face's outward normal, its orientation included. A figure which was not computed is None. limits_proven is False
    where curvature could only be sampled somewhere; self_intersection is "none", or "undecided" where the search for
    distant parts that meet ran out of its budget.

    A base with creases is torn into parts: faces is their number, gap a proven bound in mm of the distance between
    two parts' edges along a crease, crease "gap", "overlap" or "both" for what they do there. For a single face, gap
    and crease are None. Errors are the largest of the parts, limits the tightest, and surface is that of the largest
    part; loops and edges are the base's.
    """

    def to_json(self) -> str:
        """The report as indented JSON text."""
        return json.dumps(self._values, indent=2, ensure_ascii=False)

    @classmethod
    def from_json(cls, text: str) -> "OffsetReport":
        """The report which to_json wrote."""
        return cls(json.loads(text))

    def summary(self) -> str:
        """One line for a person: the outcome, and the size and error of the result."""
        if self.status != "ok":
            return f"refused ({self.status}, {self.stage}): {self.message}"
        return ", ".join(["ok", self._surface_in_words(), *self._tear_in_words(), self._error_in_words()])

    def _tear_in_words(self) -> List[str]:
        if self._values.get("faces", 1) < 2:
            return []
        gap = self._values.get("gap")
        width = "" if gap is None else f", torn by up to {gap:.3g} mm"
        return [f"{self.faces} faces along creases{width}"]

    def _surface_in_words(self) -> str:
        surface = self.surface
        if surface.type != "bspline":
            return f"exact {surface.type}"
        kind = "rational B-spline" if surface.rational else "B-spline"
        return f"{kind}, degree {surface.degree_u} x {surface.degree_v}, {surface.poles_u} x {surface.poles_v} poles"

    def _error_in_words(self) -> str:
        if self.certified_error is not None:
            return f"proven error {self.certified_error:.3g} mm"
        if self.sampled_error is not None:
            return f"sampled error {self.sampled_error:.3g} mm"
        return "error not measured"
