# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compiled part of laminate_offset. Use the functions of laminate_offset instead."""

from typing import Any, Callable, Dict, Optional, Tuple

__version__: str
occt_version: str

def default_options() -> Dict[str, Any]: ...
def offset_face(
    shape: Any,
    distance: float,
    tolerance: float = ...,
    method: str = ...,
    extension: float = ...,
    max_degree: Optional[int] = ...,
    progress: Optional[Callable[[float], Optional[bool]]] = ...,
) -> Tuple[Any, Dict[str, Any]]: ...
def offset_limits(shape: Any) -> str: ...
def round_trip(shape: Any, way: str) -> Any: ...
def select_shape_exchange(way: str) -> None: ...
def shape_exchange() -> str: ...
