# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset is where its base is: placements, App::Part, Body, App::Link, groups, nested and moved."""

import os
import sys

import FreeCAD as App
import Part
import pytest
from laminate_offset.features.offset_face import add_offset_face, make_offset_face, set_base

TURN = App.Rotation(App.Vector(1, 2, 3), 40)
MOVE = App.Placement(App.Vector(100, -20, 7), TURN)
OTHER_MOVE = App.Placement(App.Vector(-3, 5, 500), App.Rotation(App.Vector(0, 1, 0), 90))
TOP_OF_BOX = App.Vector(5, 5, 10)


@pytest.fixture
def box(doc):
    """A cube of 10 mm; Face6 is its top."""
    cube = doc.addObject("Part::Box", "Box")
    doc.recompute()
    return cube


def assert_above_top(offset, distance, *placements):
    """The offset's centre is distance above the cube's top, seen through all placements, outermost first."""
    assert offset.Status == "ok", offset.Message
    expected = TOP_OF_BOX + App.Vector(0, 0, distance)
    for placement in reversed(placements):
        expected = placement.multVec(expected)
    shape = offset.Document.getObject(offset.Name).getSubObject("")
    container = offset.getParentGeoFeatureGroup()
    centre = shape.CenterOfMass if container is None else container.getGlobalPlacement().multVec(shape.CenterOfMass)
    assert centre.distanceToPoint(expected) < 1e-9, (centre, expected)


def test_moved_base(doc, box):
    box.Placement = MOVE
    doc.recompute()
    offset = make_offset_face(box, "Face6", 2)
    assert_above_top(offset, 2, MOVE)
    box.Placement = OTHER_MOVE
    doc.recompute()
    assert_above_top(offset, 2, OTHER_MOVE)


def test_several_faces_of_a_moved_base(doc, box):
    box.Placement = MOVE
    doc.recompute()
    offset = make_offset_face(box, ["Face5", "Face6"], 2)
    bottom, top = offset.Shape.Faces
    assert top.CenterOfMass.distanceToPoint(MOVE.multVec(App.Vector(5, 5, 12))) < 1e-9
    assert bottom.CenterOfMass.distanceToPoint(MOVE.multVec(App.Vector(5, 5, -2))) < 1e-9


def test_base_in_nested_parts_and_a_group(doc, box):
    inner, outer = doc.addObject("App::Part", "Inner"), doc.addObject("App::Part", "Outer")
    group = doc.addObject("App::DocumentObjectGroup", "Group")
    outer.addObject(inner)
    inner.addObject(group)
    group.addObject(box)
    box.Placement, inner.Placement, outer.Placement = MOVE, OTHER_MOVE, MOVE
    doc.recompute()
    offset = make_offset_face(box, "Face6", -3)
    assert offset.Base[0][0] == outer
    assert_above_top(offset, -3, MOVE, OTHER_MOVE, MOVE)
    for moved in (outer, inner, box):
        moved.Placement = App.Placement()
        doc.recompute()
    assert_above_top(offset, -3)


def test_path_as_the_selection_gives_it(doc, box):
    part = doc.addObject("App::Part", "Part")
    part.addObject(box)
    part.Placement = MOVE
    doc.recompute()
    offset = make_offset_face(part, "Box.Face6", 1)
    assert_above_top(offset, 1, MOVE)


def test_pad_in_a_body(doc):
    # Plain Python knows FreeCAD's library folder only; FreeCAD itself also the Mod folders.
    sys.path.append(os.path.join(App.getResourceDir(), "Mod"))
    body = doc.addObject("PartDesign::Body", "Body")
    pad = doc.addObject("PartDesign::AdditiveBox", "Pad")
    body.addObject(pad)
    body.Placement = MOVE
    doc.recompute()
    (top,) = [i + 1 for i, face in enumerate(pad.Shape.Faces) if abs(face.CenterOfMass.z - 10) < 1e-9]
    offset = make_offset_face(pad, f"Face{top}", 2)
    assert_above_top(offset, 2, MOVE)
    body.Placement = OTHER_MOVE
    doc.recompute()
    assert_above_top(offset, 2, OTHER_MOVE)


def test_through_a_link(doc, box):
    link = doc.addObject("App::Link", "Link")
    link.LinkedObject = box
    link.Placement = MOVE
    doc.recompute()
    offset = make_offset_face(link, "Face6", 2)
    assert_above_top(offset, 2, MOVE)
    link.Placement = OTHER_MOVE
    doc.recompute()
    assert_above_top(offset, 2, OTHER_MOVE)


def test_link_to_a_part(doc, box):
    part, link = doc.addObject("App::Part", "Part"), doc.addObject("App::Link", "Link")
    part.addObject(box)
    box.Placement = OTHER_MOVE
    link.LinkedObject = part
    link.Placement = MOVE
    doc.recompute()
    offset = make_offset_face(link, "Box.Face6", 2)
    assert_above_top(offset, 2, MOVE, OTHER_MOVE)


def test_offset_inside_a_container_of_its_own(doc, box):
    box.Placement = OTHER_MOVE
    part = doc.addObject("App::Part", "Part")
    part.Placement = MOVE
    offset = add_offset_face(doc)
    part.addObject(offset)
    set_base(offset, [(box, ["Face6"])])
    offset.Distance = 2
    doc.recompute()
    assert box.getParentGeoFeatureGroup() is None and offset.getParentGeoFeatureGroup() == part
    assert_above_top(offset, 2, OTHER_MOVE)


def test_offset_dragged_into_a_container(doc, box):
    """FreeCAD takes the base along: both move together."""
    box.Placement = OTHER_MOVE
    doc.recompute()
    offset = make_offset_face(box, "Face6", 2)
    part = doc.addObject("App::Part", "Part")
    part.Placement = MOVE
    part.addObject(offset)
    offset.touch()
    doc.recompute()
    assert box.getParentGeoFeatureGroup() == part
    assert_above_top(offset, 2, MOVE, OTHER_MOVE)


def test_base_is_left_alone(doc, box):
    box.Placement = MOVE
    doc.recompute()
    before = (box.Shape.hashCode(), box.Shape.exportBrepToString())
    make_offset_face(box, "Face6", 2)
    assert (box.Shape.hashCode(), box.Shape.exportBrepToString()) == before


def test_located_face_in_a_compound(doc):
    face = Part.makePlane(10, 10)
    moved = face.copy()
    moved.Placement = MOVE
    base = doc.addObject("Part::Feature", "Base")
    base.Shape = Part.Compound([face, moved])
    offset = make_offset_face(base, "Face2", 4)
    assert offset.Shape.CenterOfMass.distanceToPoint(MOVE.multVec(App.Vector(5, 5, 4))) < 1e-9
