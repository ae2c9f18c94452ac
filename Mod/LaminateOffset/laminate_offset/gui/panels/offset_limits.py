# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that shows how far faces can be offset."""

import math
from typing import Any, List

from ...features.base_face import rooted_links
from ..selection import Link
from ..texts import translate
from . import base
from .base import FacePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(OffsetLimitsPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(OffsetLimitsPanel, feature)


class OffsetLimitsPanel(FacePanel):
    """Shows the limits of the faces that are picked; OK keeps the marks on the model."""

    FORM = "OffsetLimitsPanel"

    def start(self) -> None:
        """The limits are shown at once where there is a face."""
        super().start()
        if self.has_base():
            self.compute()

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        self._feature.Base = rooted_links(links)

    def faces_changed(self) -> None:
        """Other faces are picked than before: their limits take a moment only."""
        self.show_faces()
        if self.has_base():
            self.compute()

    def show_result(self) -> None:
        """Shows what the last recompute told."""
        super().show_result()
        self.form.negative.setText(self._limit(self._feature.Negative))
        self.form.positive.setText(self._limit(self._feature.Positive))

    def _limit(self, limit: Any) -> str:
        if self._feature.Status != "ok":
            return ""
        return translate("OffsetLimitsPanel", "any distance") if math.isnan(limit.Value) else f"{limit.Value:.6g} mm"
