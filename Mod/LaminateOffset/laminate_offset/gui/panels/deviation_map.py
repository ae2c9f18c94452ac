# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that edits deviation maps."""

from typing import Any, List

from ...features.offset_face import OffsetFaceFeature
from ..texts import translate
from . import base
from .base import FeaturePanel


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(DeviationMapPanel, feature)


def offsets(doc: Any) -> List[Any]:
    """The document's offsets."""
    return [obj for obj in doc.Objects if isinstance(getattr(obj, "Proxy", None), OffsetFaceFeature)]


class DeviationMapPanel(FeaturePanel):
    """Chooses the offset of one map and how finely it is sampled; shows the extreme deviations."""

    FORM = "DeviationMapPanel"
    NUMBERS = {"triangles": "Triangles"}

    def __init__(self, feature: Any):
        self._offsets = offsets(feature.Document)
        super().__init__(feature)
        self.form.offset.addItems([offset.Label for offset in self._offsets])
        if feature.Offset in self._offsets:
            self.form.offset.setCurrentIndex(self._offsets.index(feature.Offset))
        self.form.offset.currentIndexChanged.connect(lambda index: self.assign("Offset", self._offsets[index]))

    def start(self) -> None:
        """Shows the figures that are there."""
        self.show_result()

    def missing(self) -> str:
        """An offset, when there is none."""
        if self._feature.Offset is None:
            return translate("DeviationMapPanel", "Choose an offset first.")
        return ""

    def show_result(self) -> None:
        """Shows what the last recompute told."""
        super().show_result()
        good = self._feature.Status == "ok"
        self.form.lowest.setText(f"{self._feature.Lowest.Value:.4g} mm" if good else "")
        self.form.highest.setText(f"{self._feature.Highest.Value:.4g} mm" if good else "")
