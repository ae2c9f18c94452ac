# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wording of outcomes."""

import math

import pytest
from laminate_offset import OffsetError, messages

ANALYTIC = {"type": "cylinder", "degree_u": 0, "degree_v": 0, "poles_u": 0, "poles_v": 0, "rational": False}
SPLINE = {"type": "bspline", "degree_u": 5, "degree_v": 4, "poles_u": 12, "poles_v": 8, "rational": True}


@pytest.mark.parametrize(
    "value, text",
    [(0.00042, "0.00042 mm"), (12.34567, "12.35 mm"), (None, "not available"), (math.nan, "not available")],
)
def test_number(value, text):
    assert messages.number(value) == text


def test_surface_type():
    assert messages.surface_type(ANALYTIC) == "exact cylinder"
    assert messages.surface_type(SPLINE) == "rational B-spline of degree 5 x 4 with 12 x 8 = 96 poles"


def test_a_sampled_figure_is_never_called_proven():
    report = {"surface": SPLINE, "certified_error": None, "sampled_error": 4e-4, "limits": None}
    assert messages.summary(report).endswith("sampled error 0.0004 mm")
    assert "proven" not in messages.summary(report)
    report["certified_error"] = 5e-4
    assert "proven error 0.0005 mm" in messages.summary(report) and "sampled" not in messages.summary(report)


@pytest.mark.parametrize("limits", [{"negative": -9.5, "positive": None}, (-9.5, None)])
def test_limits_of_report_and_error_read_alike(limits):
    assert messages.feasible_range(limits) == "from -9.5 mm up to any positive one"


def test_refusal_names_face_reason_place_and_range():
    where = {"u": 0.0, "v": 1.0, "x": 1.0, "y": 2.0, "z": 3.5}
    error = OffsetError("curvature-limit", "surface", "It folds.", where, (-9.5, 8.0))
    text = messages.refusal(error, "Face3")
    assert text == "Face3: It folds. Place: (1, 2, 3.5) mm. Feasible distances: from -9.5 mm up to 8 mm."


def test_place_shows_rounding_noise_as_zero():
    assert messages.place({"x": 6.1e-16, "y": -1e-12, "z": -10.0}) == "(0, 0, -10) mm"


def test_refusal_of_any_other_error():
    assert messages.refusal(ValueError("The tolerance is 0.")) == "The tolerance is 0."
