# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parametric document objects. Usable without the GUI."""
