# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin's nodes, as FreeCAD lends them: from 1.0 on only once pivy is loaded, which earlier versions load by themselves."""

import importlib
from typing import Any


def scene_graph(view: Any) -> Any:
    """The scene of a 3-D view; None for a window of another kind."""
    importlib.import_module("pivy.coin")
    return view.getSceneGraph() if hasattr(view, "getSceneGraph") else None


def root_node(vobj: Any) -> Any:
    """The node with everything that a view provider draws."""
    importlib.import_module("pivy.coin")
    return vobj.RootNode
