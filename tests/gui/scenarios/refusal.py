# SPDX-License-Identifier: LGPL-2.1-or-later
"""A distance that can not work: the panel says so and stays; another one works. An expression drives the distance."""

import math

import FreeCADGui as Gui
from PySide import QtGui
from session import (
    edit,
    look_at_all,
    offsets,
    press,
    result_is_red,
    result_text,
    run_command,
    screenshot,
    select,
    start,
    type_into,
    widget,
    words_in,
)

BUTTON = QtGui.QDialogButtonBox


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start()
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius = 10
    doc.recompute()
    look_at_all()
    select(ball, "Face1")
    run_command()
    refused(doc)
    repaired(doc)
    out_of_date(doc, ball)
    driven_by_expression(doc, ball)
    cancelled(doc, ball)


def refused(doc) -> None:
    """15 mm inwards passes the centre of a sphere of radius 10 mm."""
    type_into("distance", "-15")
    press(BUTTON.Ok)
    assert Gui.Control.activeDialog(), "the panel must stay when the offset is refused"
    (offset,) = offsets(doc)
    assert offset.Status == "curvature-limit" and offset.Shape.isNull()
    assert result_is_red() and "Face1" in result_text() and "-15" in result_text(), result_text()
    assert offset.RefusedAt and words_in(offset), "the place is marked on the model"
    screenshot("refused")


def repaired(doc) -> None:
    """With 4 mm inwards the same panel succeeds."""
    type_into("distance", "-4")
    press(BUTTON.Ok)
    assert not Gui.Control.activeDialog()
    (offset,) = offsets(doc)
    assert offset.Status == "ok" and math.isclose(offset.Shape.Faces[0].Surface.Radius, 6)
    assert not words_in(offset)


def out_of_date(doc, ball) -> None:
    """A base that changes under a good offset: the old shape stays, dashed and with a word on it."""
    (offset,) = offsets(doc)
    ball.Radius = 3
    doc.recompute()
    look_at_all()
    assert offset.OutOfDate and math.isclose(offset.Shape.Faces[0].Surface.Radius, 6)
    assert offset.ViewObject.DrawStyle == "Dashed" and "out of date" in words_in(offset)[0]
    screenshot("out_of_date")
    ball.Radius = 10
    doc.recompute()
    assert not offset.OutOfDate and offset.ViewObject.DrawStyle == "Solid" and not words_in(offset)


def driven_by_expression(doc, ball) -> None:
    """The panel shows and keeps an expression."""
    (offset,) = offsets(doc)
    offset.setExpression("Distance", "Ball.Radius / 2")
    doc.recompute()
    edit(offset)
    assert widget("distance").property("rawValue") == 5.0
    press(BUTTON.Ok)
    ball.Radius = 12
    doc.recompute()
    assert math.isclose(offset.Shape.Faces[0].Surface.Radius, 18)


def cancelled(doc, ball) -> None:
    """Cancel takes a new offset back without a trace."""
    steps = doc.UndoCount
    select(ball, "Face1")
    run_command()
    assert len(offsets(doc)) == 2
    press(BUTTON.Cancel)
    assert len(offsets(doc)) == 1 and doc.UndoCount == steps
