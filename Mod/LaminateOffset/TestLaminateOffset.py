# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests that a user can run in FreeCAD's test workbench, or with `freecadcmd -t TestLaminateOffset`.

They show that the add-on works with this FreeCAD: shapes cross to the engine and back, and every object computes.
"""

import unittest

import FreeCAD as App


class TestLaminateOffset(unittest.TestCase):
    """One object of every kind on simple faces, whose results are known in closed form."""

    def setUp(self):
        self.doc = App.newDocument("TestLaminateOffset")
        self.ball = self.doc.addObject("Part::Sphere", "Ball")
        self.ball.Radius = 10
        self.doc.recompute()

    def tearDown(self):
        App.closeDocument(self.doc.Name)

    def test_shapes_cross_to_the_engine_and_back(self):
        import laminate_offset

        result = laminate_offset.offset_face(self.ball.Shape.Face1, 2.0)
        self.assertTrue(result.face.isValid())
        self.assertIn(laminate_offset.shape_exchange(), ("zero-copy", "binary", "brep-text"))

    def test_offset_follows_its_base(self):
        from laminate_offset.features.offset_face import make_offset_face

        offset = make_offset_face(self.ball, "Face1", 2)
        self.assertAlmostEqual(offset.Shape.Faces[0].Surface.Radius, 12)
        self.ball.Radius = 20
        self.doc.recompute()
        self.assertAlmostEqual(offset.Shape.Faces[0].Surface.Radius, 22)

    def test_refusal_keeps_the_last_good_shape(self):
        from laminate_offset.features.offset_face import make_offset_face

        offset = make_offset_face(self.ball, "Face1", -4)
        self.ball.Radius = 3
        self.doc.recompute()
        self.assertTrue(offset.OutOfDate)
        self.assertEqual(offset.Status, "curvature-limit")
        self.assertAlmostEqual(offset.Shape.Faces[0].Surface.Radius, 6)

    def test_limits(self):
        from laminate_offset.features.offset_limits import make_offset_limits

        limits = make_offset_limits(self.ball, "Face1")
        self.assertAlmostEqual(limits.Negative.Value, -10, delta=0.02)

    def test_extension(self):
        from laminate_offset.features.extend_face import make_extend_face

        plane = self.doc.addObject("Part::Plane", "Plane")
        plane.Length = plane.Width = 10
        self.doc.recompute()
        self.assertAlmostEqual(make_extend_face(plane, "Face1", 5).Shape.Area, 400)

    def test_stack_and_core_sample(self):
        from laminate_offset.features.core_sample import make_core_sample
        from laminate_offset.features.layup import make_layup
        from laminate_offset.features.ply_stack import OUTPUTS, make_ply_stack, plies_of
        from laminate_offset.layup import layup_from_notation

        layup = make_layup(self.doc, layup_from_notation("[0/±45/90]s", "IM7-8552-134"))
        stack = make_ply_stack(self.ball, "Face1", layup, output=OUTPUTS[1])
        self.assertEqual([stack.Status, stack.PlyCount, len(plies_of(stack))], ["ok", 8, 8])
        core = make_core_sample(stack, (20, 0, 0))
        self.assertEqual(core.PlyCount, 8)
        self.assertAlmostEqual(core.Thickness.Value, layup.Thickness.Value)

    def test_stack_section(self):
        from laminate_offset.features.layup import make_layup
        from laminate_offset.features.ply_stack import make_ply_stack
        from laminate_offset.features.stack_section import make_stack_section
        from laminate_offset.layup import layup_from_notation

        layup = make_layup(self.doc, layup_from_notation("[0/90]", "IM7-8552-134"))
        section = make_stack_section(make_ply_stack(self.ball, "Face1", layup), (0, 0, 1), 0)
        self.assertEqual([section.Status, section.PlyCount], ["ok", 2])

    def test_rosette(self):
        from laminate_offset.features.rosette import make_rosette

        axis = make_rosette(self.ball, "Face1", (0, 0, 20), (1, 0, 5)).FirstAxis
        self.assertAlmostEqual(axis.distanceToPoint(App.Vector(1, 0, 0)), 0)

    def test_curvature_map(self):
        from laminate_offset.features.curvature_map import make_curvature_map

        self.assertAlmostEqual(make_curvature_map(self.ball, "Face1", -5).LargestUse, 0.5)

    def test_deviation_map(self):
        from laminate_offset.features.deviation_map import make_deviation_map
        from laminate_offset.features.offset_face import make_offset_face

        chart = make_deviation_map(make_offset_face(self.ball, "Face1", 2), triangles=100)
        self.assertLess(max(map(abs, chart.Deviations)), 1e-6)
