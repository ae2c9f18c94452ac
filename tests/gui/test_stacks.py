# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layups, ply stacks, core samples and what else there is beside offsets, in FreeCAD's GUI."""

import os
import pathlib

import pytest
from freecad_gui import run_scenario

DATA = pathlib.Path(os.environ["LAMINATE_OFFSET_PROJECT_DIR"]).parent / "shared" / "data"


def test_layup_is_typed_and_stacked():
    run_scenario("layup_and_stack")


def test_ends_of_plies_are_staggered():
    refusals = ["not of the form", "no list of distances", "which has 2 plies", "use one of Patch"]
    run_scenario("stagger", refusals=refusals)


def test_sides_ramps_and_warnings():
    run_scenario("ramps", refusals=["it has no inside", "'ramp' not found"])


def test_limits_extension_and_deviation():
    run_scenario("other_commands", refusals=["tick at least one"])


def test_maps_folds_exploded_views_and_sections():
    run_scenario("seeing", refusals=["Face1", "does not cut"])


def test_rosette_is_picked_and_used():
    run_scenario("rosette", refusals=["no normal to turn about"])


def test_event_loop_goes_on_during_previews():
    if not DATA.is_dir():
        pytest.skip("../shared/data is not there")
    run_scenario("responsive")


def test_escape_ends_a_stack_of_200_plies():
    if not DATA.is_dir():
        pytest.skip("../shared/data is not there")
    run_scenario("cancel_stack", refusals=["cancelled"])


def test_preferences_and_languages():
    run_scenario("preferences")


@pytest.mark.parametrize("dark", [False, True])
def test_tutorial(dark):
    run_scenario("tutorial", dark=dark)


def test_missing_core_is_told():
    run_scenario("missing_core", refusals=["compiled part could not be loaded"])
