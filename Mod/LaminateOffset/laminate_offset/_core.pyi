# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compiled part of laminate_offset. Use the functions of laminate_offset instead."""

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

__version__: str
occt_version: str

class LaidLayer: ...

def default_options() -> Dict[str, Any]: ...
def evaluate_face(shape: Any, uv: Any) -> Tuple[Any, Any, Any]: ...
def extend_face(shape: Any, length: float, sides: Sequence[str], continuity: str, rule: str) -> Tuple[Any, str]: ...
def face_integrals(
    shape: Any, distances: Sequence[float], intervals: Sequence[Tuple[float, float]]
) -> Dict[str, Any]: ...
def limit_threads(count: int) -> None: ...
def nearest_point(shape: Any, points: Any, trimmed: bool = ...) -> Tuple[Any, Any, Any]: ...
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
def offset_stack(
    shape: Any,
    distances: Sequence[float],
    tolerance: float = ...,
    max_degree: Optional[int] = ...,
    each: bool = ...,
    progress: Optional[Callable[[float], Optional[bool]]] = ...,
) -> Tuple[List[Tuple[Any, Dict[str, Any]]], bool, float]: ...
def ply_integrals(region: Any, layers: Sequence[LaidLayer]) -> List[Dict[str, Any]]: ...
def ply_solids(faces: Sequence[Any], spans: Sequence[Tuple[int, int]]) -> List[Any]: ...
def project_curve(
    shape: Any, edge_or_wire: Any, tolerance: float = ..., outside: str = ...
) -> Tuple[Any, List[Dict[str, Any]], Optional[float], float]: ...
def round_trip(shape: Any, way: str) -> Any: ...
def select_shape_exchange(way: str) -> None: ...
def shape_exchange() -> str: ...
def stack_plies(
    shape: Any,
    plies: Sequence[Tuple[float, Optional[int], float]],
    boundaries: Sequence[Tuple[str, Any, str, Tuple[float, float, float]]],
    tolerance: float = ...,
    max_degree: Optional[int] = ...,
    direction: float = ...,
    start: float = ...,
    ratio: float = ...,
    ramp_length: Optional[float] = ...,
    ramp_slope: str = ...,
    boundary_gap: Optional[float] = ...,
    middle: bool = ...,
    progress: Optional[Callable[[float], Optional[bool]]] = ...,
) -> Tuple[
    List[Tuple[Any, Any, Any, Any, LaidLayer, Optional[Dict[str, float]]]], List[Optional[float]], float, float
]: ...
def write_step_assembly(
    path: str, name: str, parts: Sequence[Tuple[Any, str, Tuple[float, float, float]]], schema: str
) -> None: ...
