# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that edits a layup: a table of plies, from the tool outwards."""

import json
from typing import Any, Dict, List

from ...features.layup import read_rows, set_layup
from ...features.ply_stack import PlyStackFeature, link_boundaries, link_rosettes
from ...features.rosette import RosetteFeature
from ...layup import LayupError, materials
from ...layup.documents import FORMAT, VERSION, layup_document
from ..commands import layup_files
from ..commands.base import all_of
from ..ply_table import ANGLES, PlyTable
from ..texts import translate
from . import base
from .base import FeaturePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(LayupPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(LayupPanel, feature)


class LayupPanel(FeaturePanel):
    """Edits one layup. Every change is checked at once; what is wrong is red, and OK waits until it is right."""

    FORM = "LayupPanel"
    WIDTH = 600
    CHOICES = {"direction": "Direction", "reference": "Reference"}
    TICKS = {"symmetric": "Symmetric", "middlePly": "MiddlePly"}
    NUMBERS = {"repeat": "Repeat"}

    def __init__(self, feature: Any):
        self._own: List[Dict[str, Any]] = []
        super().__init__(feature)
        rosettes = [rosette.Label for rosette in all_of(RosetteFeature, self._doc)]
        self._table = PlyTable(self.form.rows, list(materials()), rosettes, self.changed)
        self.form.angles.addItem(translate("LayupPanel", "Angle..."))
        self.form.angles.addItems([f"{angle}\N{DEGREE SIGN}" for angle in ANGLES])
        self.form.angles.activated.connect(self._angle_chosen)
        for name in ("add", "duplicate", "mirror", "delete", "up", "down"):
            self._widget(name).clicked.connect(lambda _on=False, do=getattr(self._table, name): do())
        self.form.importFile.clicked.connect(lambda *_: self._import())
        self.form.exportFile.clicked.connect(lambda *_: self._export())
        self._show_table()

    def start(self) -> None:
        """Shows the figures of the table."""
        self.changed()

    def changed(self) -> None:
        """Checks the rows and shows the running totals."""
        if not hasattr(self, "_table"):
            return  # still being filled
        try:
            layup = self._layup()
        except LayupError as error:
            self._table.mark(error.problems)
            self.form.total.setText("")
            self._tell_problems(error)
            return
        self._table.mark([])
        count = len(layup.physical_plies())
        text = translate("LayupPanel", "{count} plies, {thickness} mm").format(
            count=count, thickness=f"{layup.thickness:.6g}"
        )
        self.form.total.setText(text)
        self.tell(layup.notation() if count else translate("LayupPanel", "No ply is active."))

    def compute(self, *_checked: Any) -> bool:
        """Stores the table, if it is right, and links what its rows name to the stacks of the layup."""
        try:
            set_layup(self._feature, self._layup())
        except LayupError as error:
            self._tell_problems(error)
            return False
        self._doc.recompute([self._feature])
        for stack in all_of(PlyStackFeature, self._doc):
            if stack.Layup == self._feature:
                link_boundaries(stack)
                link_rosettes(stack)
        return self._feature.Status == "ok"

    def _layup(self) -> Any:
        """The layup that the panel shows. Raises LayupError."""
        document = {
            "format": FORMAT,
            "version": VERSION,
            "repeat": self.form.repeat.value(),
            "symmetric": self.form.symmetric.isChecked(),
            "middle_ply": self.form.middlePly.isChecked(),
            "direction": self.form.direction.currentText(),
            "reference": self.form.reference.currentText(),
            "materials": self._own,
            "plies": self._table.rows(),
        }
        return read_rows(document, self._feature.Label)

    def _show_table(self) -> None:
        """Fills the table from the object; an object whose table is wrong shows it all the same."""
        table = json.loads(self._feature.Table)
        self._own = table.get("materials", [])
        self._table.show(table["plies"], [entry["material"] for entry in self._own])

    def _angle_chosen(self, index: int) -> None:
        if index > 0:
            self._table.set_angle(ANGLES[index - 1])
            self.form.angles.setCurrentIndex(0)

    def _import(self) -> None:
        layup = layup_files.ask_and_read()
        if layup is not None:
            document = layup_document(layup)
            self._own = document["materials"]
            self.form.repeat.setValue(layup.repeat)
            self.form.symmetric.setChecked(layup.symmetric)
            self.form.middlePly.setChecked(layup.middle_ply)
            self.form.direction.setCurrentText(layup.direction)
            self.form.reference.setCurrentText(layup.reference)
            self._table.show(document["plies"], [entry["material"] for entry in self._own])
            self.changed()

    def _export(self) -> None:
        try:
            layup = self._layup()
        except LayupError as error:
            self._tell_problems(error)
            return
        layup_files.ask_and_write(layup, self._feature.Label)

    def _tell_problems(self, error: LayupError) -> None:
        """What is wrong, with the titles of the table's columns."""
        self.tell(str(LayupError(error.source, self._table.titled(error.problems))), refused=True)
