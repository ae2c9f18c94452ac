# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fresh document with undo for every test."""

import FreeCAD as App
import pytest


@pytest.fixture
def doc():
    document = App.newDocument("Test")
    document.UndoMode = 1
    name = document.Name
    yield document
    if name in App.listDocuments():
        App.closeDocument(name)


@pytest.fixture
def ball(doc):
    """A sphere of radius 10 mm."""
    sphere = doc.addObject("Part::Sphere", "Ball")
    sphere.Radius = 10
    doc.recompute()
    return sphere
