# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Offset Face in FreeCAD's GUI. Pictures are left in tests/gui/out of the build tree."""

import pytest
from freecad_gui import run_scenario


@pytest.mark.parametrize("install", ["option", "user"])
def test_life_of_an_offset(install):
    run_scenario("life", install)


def test_refusal_stays_in_the_panel():
    run_scenario("refusal", refusals=["Face1"])


def test_face_is_picked_with_the_mouse():
    run_scenario("picking")


def test_long_work_is_cancelled_with_escape():
    run_scenario("cancel_long_work", refusals=["cancelled"])


def test_free_form_panel_to_both_sides():
    run_scenario("panel")


def test_documents_written_without_the_gui():
    run_scenario("headless")
