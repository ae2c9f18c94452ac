# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extensions, limits, layups, stacks, core samples and deviation maps as document objects."""

import math
import os
import pathlib

import FreeCAD as App
import Part
import pytest
from laminate_offset.features.core_sample import make_core_sample
from laminate_offset.features.deviation_map import make_deviation_map
from laminate_offset.features.extend_face import make_extend_face
from laminate_offset.features.layup import import_layup, layup_of, make_layup, set_layup
from laminate_offset.features.offset_face import make_offset_face
from laminate_offset.features.offset_limits import make_offset_limits
from laminate_offset.features.ply_stack import COLOURS, OUTPUTS, make_ply_stack, plies_of, result_of
from laminate_offset.layup import Layup, Ply, layup_from_notation, read_layup
from shapes import wavy_face

ADDON = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset"
TABLE = str(ADDON / "resources" / "examples" / "layup_plain.csv")


@pytest.fixture
def wavy(doc):
    """A free-form face."""
    base = doc.addObject("Part::Feature", "Wavy")
    base.Shape = wavy_face()
    return base


@pytest.fixture
def layup(doc):
    """Six plies, 0.848 mm."""
    return import_layup(doc, TABLE)


def is_invalid(feature):
    return "Invalid" in feature.State


def test_extension_has_units_and_follows_its_base(doc):
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length, plane.Width = 20, 30
    doc.recompute()
    extended = make_extend_face(plane, "Face1", 5)
    assert extended.Status == "ok" and extended.Shape.Area == pytest.approx(30 * 40)
    extended.UMin = extended.UMax = False
    extended.setExpression("Length", "Plane.Width / 3")
    doc.recompute()
    assert extended.Shape.Area == pytest.approx(20 * 50)
    plane.Width = 60
    doc.recompute()
    assert extended.Shape.Area == pytest.approx(20 * 100)
    extended.VMin = extended.VMax = False
    doc.recompute()
    assert is_invalid(extended) and extended.OutOfDate and extended.Shape.Area == pytest.approx(20 * 100)
    assert extended.Status == "invalid-option" and "tick at least one" in extended.Message


def test_extension_of_a_closed_face_is_refused(ball):
    extended = make_extend_face(ball, "Face1", 5)
    assert is_invalid(extended) and extended.Shape.isNull() and extended.Message.startswith("Face1: ")


def test_limits_of_a_sphere(doc, ball):
    limits = make_offset_limits(ball, "Face1")
    assert limits.Negative.Value == pytest.approx(-10, rel=1e-3) and math.isnan(limits.Positive.Value)
    assert limits.Proven and len(limits.Places) == 1 and limits.Places[0].Length == pytest.approx(10)
    (edge,) = limits.Shape.Edges
    assert edge.Length == pytest.approx(10, rel=1e-3)
    assert min(vertex.Point.Length for vertex in edge.Vertexes) < 0.02, "the normal ends in the centre of curvature"
    ball.Radius = 4
    doc.recompute()
    assert limits.Negative.Value == pytest.approx(-4, rel=1e-3)


def test_limits_of_several_faces_are_the_tightest(doc, ball):
    can = doc.addObject("Part::Cylinder", "Can")
    can.Radius = 3
    doc.recompute()
    limits = make_offset_limits(can, ["Face1", "Face2", "Face3"])
    assert limits.Negative.Value == pytest.approx(-3, rel=1e-3)
    plane = make_offset_limits(can, "Face2")
    assert math.isnan(plane.Negative.Value) and plane.Places == [] and "any negative one" in plane.Message


def test_layup_keeps_what_the_file_holds(doc, layup):
    assert layup_of(layup) == read_layup(TABLE) and layup.Label == "layup_plain"
    assert layup.PlyCount == 6 and layup.Thickness.Value == pytest.approx(0.848) and layup.Notation == "[45/0/±45/90/0]"
    layup.Symmetric, layup.Repeat = True, 2
    doc.recompute()
    assert layup.PlyCount == 24 and layup.Thickness.Value == pytest.approx(4 * 0.848)
    options = layup_from_notation("[0/90~]s", "IM7-8552-134")
    set_layup(layup, options)
    assert layup_of(layup) == options and layup.MiddlePly and layup.Repeat == 1


def test_wrong_layup_is_refused_row_by_row(doc, layup):
    layup.Table = layup.Table.replace('"angle_deg": 90.0', '"angle_deg": 900')
    doc.recompute()
    assert is_invalid(layup) and layup.Status == "invalid-layup" and layup.PlyCount == 0
    told = "layup_plain: ply 5, angle_deg: found 900, expected a number of degrees from -180 to 180."
    assert layup.Message == told.replace("900", "'900'") or layup.Message == told
    layup.Table = "nonsense"
    doc.recompute()
    assert is_invalid(layup) and "edit the layup" in layup.Message


def test_stack_lies_where_the_layup_says(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", layup)
    assert stack.Status == "ok" and stack.PlyCount == len(stack.Shape.Faces) == 6
    assert 0 < stack.CertifiedError.Value <= stack.Tolerance.Value and stack.Thickness.Value == pytest.approx(0.848)
    u, v = 0.4, 0.4
    base, top = wavy.Shape.Face1, stack.Shape.Faces[-1]
    gap = Part.Vertex(base.valueAt(u, v)).distToShape(top)[0]
    assert gap == pytest.approx(0.848, abs=1e-3)
    layup.Direction = "reversed"
    doc.recompute()
    side = (stack.Shape.Faces[-1].valueAt(u, v) - base.valueAt(u, v)).dot(base.normalAt(u, v))
    assert side == pytest.approx(-0.848, abs=1e-3)


def test_stack_without_face_or_layup_is_refused(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", None)
    assert is_invalid(stack) and "No layup is chosen" in stack.Message
    stack.Layup = layup
    doc.recompute()
    assert stack.Status == "ok"
    layup.Table = "nonsense"
    stack.touch()
    doc.recompute()
    assert is_invalid(layup) and not stack.Shape.isNull()
    doc.removeObject(layup.Name)
    doc.recompute()
    assert is_invalid(stack) and stack.OutOfDate and len(stack.Shape.Faces) == 6


def test_stack_past_the_curvature_is_refused_with_its_place(doc, wavy):
    layup = make_layup(doc, layup_from_notation("[0]200", "EGlass-7781-Epoxy"))
    assert layup.PlyCount == 200 and layup.Thickness.Value > 30
    stack = make_ply_stack(wavy, "Face1", layup)
    assert is_invalid(stack) and stack.Status == "curvature-limit" and len(stack.RefusedAt) == 1
    assert stack.Message.startswith("Face1: ") and "Feasible distances" in stack.Message


def test_named_plies_come_and_go_with_the_layup(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    plies = plies_of(stack)
    assert [ply.Label for ply in plies] == [f"P{number}" for number in range(1, 7)]
    assert [ply.FibreAngle.Value for ply in plies] == [45, 0, 45, -45, 90, 0]
    for ply, face in zip(plies, stack.Shape.Faces):
        assert ply.Status == "ok" and ply.Shape.Area == pytest.approx(face.Area) and ply.Shape.isValid()
    assert plies[0].Material == "AS4-8552S-PW-193" and plies[5].Top.Value == pytest.approx(0.848)
    layup.Symmetric = True
    doc.recompute()
    doc.recompute()
    assert len(plies_of(stack)) == 12 and all("Up-to-date" in obj.State for obj in doc.Objects)
    layup.Symmetric = False
    doc.recompute()
    assert len(plies_of(stack)) == 6 and all("Up-to-date" in obj.State for obj in doc.Objects)
    stack.Output = OUTPUTS[0]
    doc.recompute()
    assert plies_of(stack) == [] and stack.Status == "ok"


def test_solid_plies(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    stack.Solids = True
    doc.recompute()
    assert stack.Status == "ok" and len(stack.Shape.Solids) == 6
    for ply in plies_of(stack):
        (solid,) = ply.Shape.Solids
        assert solid.isValid() and solid.isClosed()
        assert solid.Volume == pytest.approx(ply.Thickness.Value * wavy.Shape.Area, rel=0.05)


def test_boundaries_are_found_by_their_labels(doc, layup):
    plane = doc.addObject("Part::Plane", "Plane")
    circle = doc.addObject("Part::Circle", "Circle")
    circle.Label, circle.Radius = "Patch", 20
    circle.Placement.Base = App.Vector(50, 50, 0)
    doc.recompute()
    set_layup(layup, Layup((Ply("P1", "A", 0.2), Ply("P2", "A", 0.2, boundary="Patch"))))
    doc.recompute()
    stack = make_ply_stack(plane, "Face1", layup)
    assert stack.Status == "ok" and stack.Boundaries == [circle], stack.Message
    inside, outside = make_core_sample(stack, (50, 50, 0)), make_core_sample(stack, (5, 5, 0))
    assert (inside.PlyCount, outside.PlyCount) == (2, 1)
    assert (inside.Thickness.Value, outside.Thickness.Value) == (pytest.approx(0.4), pytest.approx(0.2))
    circle.Radius = 5
    doc.recompute()
    assert make_core_sample(stack, (50, 62, 0)).PlyCount == 1
    stack.Boundaries = []
    doc.recompute()
    assert is_invalid(stack) and stack.OutOfDate and stack.Status == "invalid-layup"
    assert (
        "name the boundary 'Patch', which is not among the stack's; give a curve or a sketch that label"
        in stack.Message
    )


def plate(doc):
    """A square of 100 x 100 mm, its normal along z."""
    plane = doc.addObject("Part::Plane", "Plane")
    plane.Length = plane.Width = 100
    doc.recompute()
    return plane


def halved_stack(doc, layup):
    """A ply on a whole square, and one of 0.5 mm beside a line along y at x = 50, from y = -10 to 110."""
    plane, line = plate(doc), doc.addObject("Part::Line", "Line")
    line.Label = "Edge"
    (line.X1, line.Y1), (line.X2, line.Y2) = (50, -10), (50, 110)
    line.Z1 = line.Z2 = 0
    doc.recompute()
    set_layup(layup, Layup((Ply("P1", "A", 0.5, boundary="Edge"), Ply("P2", "A", 0.5))))
    doc.recompute()
    return make_ply_stack(plane, "Face1", layup)


def test_open_boundaries_have_sides(doc, layup):
    stack = halved_stack(doc, layup)
    assert is_invalid(stack) and stack.Status == "invalid-option"
    assert "Boundary 'Edge': A curve of it is open" in stack.Message
    assert "give its label left or right in Sides" in stack.Message and "point" not in stack.Message
    for entries, place in ((["Edge=left"], 25), ([" Edge = right "], 75), (["", "Edge=left"], 25)):
        stack.Sides = entries
        doc.recompute()
        assert stack.Status == "ok", stack.Message
        region = result_of(stack).plies[0].base_face
        assert region.Area == pytest.approx(5000) and region.CenterOfMass.x == pytest.approx(place)


@pytest.mark.parametrize(
    "entries,told",
    [
        (["Edge"], "Sides: 'Edge' is not of the form NAME=SIDE."),
        (["Edge=below"], "Sides: 'Edge=below' does not name one of inside, outside, left, right."),
        (["Seam=left"], "Sides: there is no boundary 'Seam'; use one of Edge."),
        (["Edge=left", "Edge=right"], "Sides: the boundary 'Edge' is given twice; keep one."),
    ],
)
def test_wrong_sides_are_told(doc, layup, entries, told):
    stack = halved_stack(doc, layup)
    stack.Sides = entries
    doc.recompute()
    assert is_invalid(stack) and stack.Status == "invalid-option" and stack.Message == told


def test_ramps_have_a_length_and_a_slope(doc, layup):
    stack = halved_stack(doc, layup)
    stack.Sides = ["Edge=left"]
    doc.recompute()
    assert (stack.RampLength.Value, stack.RampSlope) == (0, "mean") and stack.Status == "ok", stack.Message

    def ramp():
        return result_of(stack).plies[0].ramp

    assert ramp()["length"] == pytest.approx(10)  # 20 times 0.5 mm
    stack.RampLength = "30 mm"
    doc.recompute()
    assert ramp()["length"] == pytest.approx(30) and ramp()["mean_slope"] == pytest.approx(0.5 / 30)
    assert ramp()["steepest_slope"] > 1.2 * 0.5 / 30
    assert len(set(stack.getEnumerationsOfProperty("RampSlope"))) == 2
    stack.RampSlope = "steepest"
    doc.recompute()
    assert ramp()["steepest_slope"] <= 0.5 / 30 * (1 + 1e-9) and ramp()["length"] > 36
    stack.RampLength = 0
    doc.recompute()
    assert ramp()["steepest_slope"] <= 1 / 20 * (1 + 1e-9)
    for ratio in (0, -1):
        stack.DropOff = ratio
        doc.recompute()
        assert is_invalid(stack) and stack.Message.startswith("Drop-off must be above 0"), stack.Message
    stack.RampLength = 5
    doc.recompute()
    assert stack.Status == "ok" and ramp()["steepest_slope"] <= 0.1 * (1 + 1e-9)


def test_warnings_are_kept_apart_and_in_the_message(doc, layup):
    stack = halved_stack(doc, layup)
    stack.Sides = ["Edge=left"]
    set_layup(layup, Layup((*(Ply(name, "A", 0.5, boundary="Edge") for name in ("P1", "P2")), Ply("P3", "A", 0.5))))
    doc.recompute()
    (warning,) = stack.Warnings
    assert stack.Status == "ok" and "Plies P1 and P2 end along one line" in warning
    assert stack.Message == f"{result_of(stack).summary()}\n{warning}"
    stack.Stagger = ["0,20,40"]
    doc.recompute()
    assert is_invalid(stack) and stack.Warnings == []
    stack.Stagger = ["0,20"]
    doc.recompute()
    assert stack.Status == "ok" and stack.Warnings == [] and stack.Message == result_of(stack).summary()


def staggered_stack(doc, layup):
    """Two plies on a circle of radius 20 on a plane, with what the second keeps inside of it still to be said."""
    plane = plate(doc)
    circle = doc.addObject("Part::Circle", "Circle")
    circle.Label, circle.Radius = "Patch", 20
    circle.Placement.Base = App.Vector(50, 50, 0)
    doc.recompute()
    set_layup(layup, Layup((Ply("P1", "A", 0.2, boundary="Patch"), Ply("P2", "A", 0.2, boundary="Patch"))))
    doc.recompute()
    return make_ply_stack(plane, "Face1", layup)


def base_radii(stack):
    """How large the circles are on which the plies stand, from their areas."""
    return [(ply.base_face.Area / math.pi) ** 0.5 for ply in result_of(stack).plies]


@pytest.mark.parametrize(
    "entries,radii",
    [
        ([], (20, 20)),
        (["0, 5"], (20, 15)),
        (["Patch=1,5"], (19, 15)),
        ([" Patch = 0 mm, 0.5 cm "], (20, 15)),
        (["", "Patch=2,0"], (18, 20)),
    ],
)
def test_successive_plies_keep_inside_of_their_boundary(doc, layup, entries, radii):
    stack = staggered_stack(doc, layup)
    stack.Stagger = entries
    doc.recompute()
    assert stack.Status == "ok", stack.Message
    assert base_radii(stack) == pytest.approx(radii, abs=1e-3)


@pytest.mark.parametrize(
    "entries,told",
    [
        (["0;5"], "Stagger: '0;5' is no list of distances in mm such as 0,8,16."),
        (["Patch=0"], "stagger has 1 distances for boundary 'Patch', which has 2 plies; give one for each"),
        (["Edge=0,5"], "stagger names the boundary 'Edge', which no ply has; use one of Patch."),
        (["Patch=0,-1"], "stagger must be a list of distances in mm or FreeCAD lengths, zero or more; -1 is none."),
        (["Patch=0,1", "Patch =0,2"], "Stagger: the boundary 'Patch' is given twice; keep one."),
        (["0,1", "Patch=0,2"], "Stagger: '0,1' is not of the form NAME=0,8,16."),
        (["Patch=0,1 s"], "Stagger: '0,1 s' is no list of distances in mm such as 0,8,16."),
        (["Patch=0,30"], "Boundary 'Patch': It cannot be moved inwards by 30 mm"),
    ],
)
def test_a_stagger_that_does_not_fit_is_told(doc, layup, entries, told):
    stack = staggered_stack(doc, layup)
    stack.Stagger = entries
    doc.recompute()
    assert is_invalid(stack) and stack.OutOfDate and told in stack.Message, stack.Message
    stack.Stagger = []
    doc.recompute()
    assert stack.Status == "ok" and not stack.OutOfDate


#: Properties of stacks that the first versions of stacks did not have, and what they hold in an older document.
LATER = {"Stagger": [], "Sides": [], "RampLength": 0, "RampSlope": "mean", "Warnings": []}


def test_a_stagger_is_saved_and_one_is_added_to_older_documents(doc, layup, tmp_path):
    stack = staggered_stack(doc, layup)
    stack.Stagger = ["Patch=0,5"]
    doc.recompute()
    older = make_ply_stack(doc.Plane, "Face1", layup, name="Older")
    for name in LATER:
        older.removeProperty(name)
    path = str(tmp_path / "staggered.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        stack, older = reopened.PlyStack, reopened.Older
        assert stack.Stagger == ["Patch=0,5"] and base_radii(stack) == pytest.approx((20, 15), abs=1e-3)
        held = {name: getattr(older, name) for name in LATER}
        assert {**held, "RampLength": held["RampLength"].Value} == LATER and older.Status == "ok"
        older.Stagger = ["0,2"]
        reopened.recompute()
        assert base_radii(older) == pytest.approx((20, 18), abs=1e-3)
    finally:
        App.closeDocument(reopened.Name)


def test_ply_of_a_deleted_stack_says_so(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    ply = plies_of(stack)[2]
    doc.removeObject(stack.Name)
    ply.touch()
    doc.recompute()
    assert is_invalid(ply) and ply.OutOfDate and "delete the ply" in ply.Message


def test_stack_in_a_moved_container(doc, wavy, layup):
    part = doc.addObject("App::Part", "Part")
    part.Placement = App.Placement(App.Vector(5, 0, 20), App.Rotation(App.Vector(1, 0, 0), 30))
    part.addObject(wavy)
    stack = make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    base = part.Placement.multVec(wavy.Shape.Face1.valueAt(0.4, 0.4))
    for shape in (stack.Shape, *(ply.Shape for ply in plies_of(stack))):
        assert Part.Vertex(base).distToShape(shape)[0] < 0.85
    inside = doc.addObject("App::Part", "Inside")
    inside.Placement.Base = App.Vector(100, 0, 0)
    inside.addObject(stack)
    doc.recompute()
    doc.recompute()
    for ply in plies_of(stack):
        assert Part.Vertex(base).distToShape(ply.Shape)[0] < 0.85


def test_core_sample_lists_the_plies(doc, wavy, layup):
    stack = make_ply_stack(wavy, "Face1", layup)
    core = make_core_sample(stack, (30, 30, 50))
    assert core.Status == "ok" and core.PlyCount == 6 and core.Thickness.Value == pytest.approx(0.848)
    assert core.Plies[0] == "1  P1  AS4-8552S-PW-193  45 deg  from 0 to 0.199 mm"
    assert [edge.Length for edge in core.Shape.Edges] == pytest.approx([0.199, 0.131, 0.131, 0.131, 0.131, 0.125])
    assert Part.Vertex(core.Foot).distToShape(wavy.Shape)[0] < 1e-7 and core.Normal.Length == pytest.approx(1)
    layup.Reference = "middle"
    doc.recompute()
    assert core.Shape.Edges[0].Vertexes[0].Point.distanceToPoint(core.Foot) == pytest.approx(0.424)
    doc.removeObject(stack.Name)
    core.touch()
    doc.recompute()
    assert is_invalid(core) and core.PlyCount == 0 and "No ply stack" in core.Message


@pytest.mark.parametrize("distance", [-3.0, 3.0])
def test_deviation_map_agrees_with_an_independent_measure(doc, wavy, distance):
    offset = make_offset_face(wavy, "Face1", distance, tolerance=1e-2)
    chart = make_deviation_map(offset, triangles=1000)
    assert chart.Status == "ok" and len(chart.Corners) >= 3000 and len(chart.Points) == len(chart.Deviations) > 500
    assert max(map(abs, chart.Deviations)) <= 1e-2
    assert max(chart.Deviations) == chart.Highest.Value > 0 > chart.Lowest.Value == min(chart.Deviations)
    for index in range(0, len(chart.Points), len(chart.Points) // 20):
        vertex = Part.Vertex(chart.Points[index])
        assert vertex.distToShape(offset.Shape)[0] < 1e-6
        # OCCT's extrema measure to the trimmed face, ours to its surface: the same away from the edges.
        seen = vertex.distToShape(wavy.Shape)[0] - abs(distance)
        assert chart.Deviations[index] == pytest.approx(seen, abs=1e-6) or seen > 1e-2


def test_deviation_map_of_a_refused_offset_is_not_made(doc, ball):
    chart = make_deviation_map(make_offset_face(ball, "Face1", -15))
    assert chart.Status != "ok" and chart.Deviations == []
    chart.Offset.Distance = 2
    doc.recompute()
    assert chart.Status == "ok" and chart.Deviations
    chart.Offset = None
    doc.recompute()
    assert is_invalid(chart) and "No offset is chosen" in chart.Message


def test_everything_is_saved_restored_and_copied(doc, wavy, layup, tmp_path):
    stack = make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    stack.Colours = COLOURS[1]
    core = make_core_sample(stack, (30, 30, 50))
    limits, extended = make_offset_limits(wavy, "Face1"), make_extend_face(wavy, "Face1", 2)
    chart = make_deviation_map(make_offset_face(wavy, "Face1", 2), triangles=100)
    names = [obj.Name for obj in (layup, stack, core, limits, extended, chart)]
    told = {name: doc.getObject(name).Message for name in names}
    path = str(tmp_path / "all.FCStd")
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    reopened = App.openDocument(path)
    try:
        assert {name: reopened.getObject(name).Message for name in names} == told
        assert all("Invalid" not in obj.State for obj in reopened.Objects)
        again = reopened.getObject(names[1])
        assert len(plies_of(again)) == 6 and again.Colours == COLOURS[1]
        twin = reopened.copyObject(reopened.getObject(names[0]), False)
        twin.Symmetric = True
        again.Layup = twin
        reopened.recompute()
        assert again.PlyCount == 12 and reopened.getObject(names[0]).PlyCount == 6
    finally:
        App.closeDocument(reopened.Name)


def test_undo_takes_a_stack_with_its_plies_back(doc, wavy, layup):
    before = len(doc.Objects)
    doc.openTransaction("Ply Stack")
    make_ply_stack(wavy, "Face1", layup, output=OUTPUTS[1])
    doc.commitTransaction()
    assert len(doc.Objects) == before + 7
    doc.undo()
    assert len(doc.Objects) == before
    doc.redo()
    doc.recompute()
    assert len(doc.Objects) == before + 7 and len(plies_of(doc.PlyStack)) == 6
