# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups, ply stacks, core samples and what else there is beside offsets, in FreeCAD's GUI."""

from freecad_gui import run_scenario


def test_layup_is_typed_and_stacked():
    run_scenario("layup_and_stack")


def test_limits_extension_and_deviation():
    run_scenario("other_commands", refusals=["tick at least one"])
