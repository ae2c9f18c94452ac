# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that makes and edits ply stacks."""

from typing import Any, List

from ...features.layup import LayupFeature, make_layup
from ...features.ply_stack import link_boundaries, link_rosettes, set_base
from ...features.rosette import RosetteFeature
from ..selection import Link
from ..texts import translate
from . import base
from .base import FacePanel


#: Between the entries of different boundaries.
_SEPARATOR = "; "


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(PlyStackPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(PlyStackPanel, feature)


def layups(doc: Any) -> List[Any]:
    """The document's layups."""
    return [obj for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), LayupFeature)]


class PlyStackPanel(FacePanel):
    """Edits one stack."""

    FORM = "PlyStackPanel"
    MANY = False
    LENGTHS = {"tolerance": "Tolerance", "rampLength": "RampLength", "boundaryGap": "BoundaryGap"}
    TICKS = {"solids": "Solids"}
    CHOICES = {"rampSlope": "RampSlope", "surface": "Surface", "output": "Output", "colours": "Colours"}
    #: Lines with an entry for every boundary, and the object's properties.
    ENTRIES = {"sides": "Sides", "stagger": "Stagger"}

    def __init__(self, feature: Any):
        self._layups: List[Any] = []
        super().__init__(feature)
        self._show_layups()
        self.form.dropOff.setValue(feature.DropOff)
        self.form.dropOff.valueChanged.connect(lambda ratio: self.assign("DropOff", ratio))
        for name, prop in self.ENTRIES.items():
            line = self._widget(name)
            line.setText(_SEPARATOR.join(getattr(feature, prop)))
            line.editingFinished.connect(lambda text=line.text, prop=prop: self._entries_typed(prop, text()))
        self._show_rosettes()
        self.form.layup.currentIndexChanged.connect(self._layup_chosen)
        self.form.newLayup.clicked.connect(self._new_layup)

    def set_links(self, links: List[Link]) -> None:
        """Links the last of these faces."""
        base_object, subs = links[-1]
        set_base(self._feature, base_object, list(subs)[-1])

    def compute(self, *checked: Any) -> bool:
        """Recomputes the stack, with the boundaries that the layup names now."""
        link_boundaries(self._feature)
        link_rosettes(self._feature)
        return super().compute(*checked)

    def missing(self) -> str:
        """A face or a layup, when there is none."""
        if not super().missing() and self._feature.Layup is None:
            return translate("PlyStackPanel", "Choose a layup first, or press New to make one.")
        return super().missing()

    def _show_layups(self) -> None:
        self._layups = layups(self._doc)
        self.form.layup.blockSignals(True)
        self.form.layup.clear()
        self.form.layup.addItems([f"{layup.Label} ({layup.Notation or layup.Message})" for layup in self._layups])
        if self._feature.Layup is None and self._layups:
            self._feature.Layup = self._layups[-1]
        if self._feature.Layup in self._layups:
            self.form.layup.setCurrentIndex(self._layups.index(self._feature.Layup))
        self.form.layup.blockSignals(False)

    def _show_rosettes(self) -> None:
        """The document's rosettes; the first entry stands for none."""
        rosettes = [
            None,
            *(obj for obj in self._doc.Objects if isinstance(getattr(obj, "Proxy", None), RosetteFeature)),
        ]
        none = translate("PlyStackPanel", "none: an axis of the model")
        self.form.rosette.addItems([none if rosette is None else rosette.Label for rosette in rosettes])
        if self._feature.Rosette in rosettes:
            self.form.rosette.setCurrentIndex(rosettes.index(self._feature.Rosette))
        self.form.rosette.currentIndexChanged.connect(lambda index: self.assign("Rosette", rosettes[index]))

    def _entries_typed(self, prop: str, text: str) -> None:
        entries = [entry.strip() for entry in text.split(_SEPARATOR.strip())]
        self.assign(prop, [entry for entry in entries if entry])

    def _layup_chosen(self, index: int) -> None:
        if 0 <= index < len(self._layups):
            self.assign("Layup", self._layups[index])

    def _new_layup(self) -> None:
        self._feature.Layup = make_layup(self._doc)
        self._show_layups()
        self.changed()
