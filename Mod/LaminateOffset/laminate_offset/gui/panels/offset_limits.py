# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel that shows how far faces can be offset."""

import math
from typing import Any

from ..texts import translate
from . import base
from .base import QuickFacePanel


def open_new(feature: Any) -> None:
    """Shows the panel on an object that was just made in an open transaction."""
    base.show(OffsetLimitsPanel(feature))


def edit(feature: Any) -> None:
    """Shows the panel on an existing object, in a transaction of its own."""
    base.edit(OffsetLimitsPanel, feature)


class OffsetLimitsPanel(QuickFacePanel):
    """Shows the limits of the faces that are picked; OK keeps the marks on the model."""

    FORM = "OffsetLimitsPanel"

    def show_result(self) -> None:
        """Shows what the last recompute told."""
        super().show_result()
        self.form.negative.setText(self._limit(self._feature.Negative))
        self.form.positive.setText(self._limit(self._feature.Positive))

    def _limit(self, limit: Any) -> str:
        if self._feature.Status != "ok":
            return ""
        return translate("OffsetLimitsPanel", "any distance") if math.isnan(limit.Value) else f"{limit.Value:.6g} mm"
