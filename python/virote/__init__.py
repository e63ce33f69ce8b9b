"""Exact freeform curves and surfaces: a declarative language, its kernel, and studies.

>>> import virote
>>> circle = virote.circle((0, 0), 2)
>>> virote.length(circle)  # doctest: +ELLIPSIS
12.56637...
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _operations
from ._findings import Check, CheckFailed, Diagnostic, GeoError, GeoWarning, Place, Print
from ._geometry import Curve, Face, Frame, Function, Mesh, Region, Solid, Surface, Table, Value
from ._operations import *  # noqa: F403
from ._results import Results
from ._session import Session, function, run

if TYPE_CHECKING:
    from ._study import StudyError, StudyResults, grid, study

__all__ = [
    "Check",
    "CheckFailed",
    "Curve",
    "Diagnostic",
    "Face",
    "Frame",
    "Function",
    "GeoError",
    "GeoWarning",
    "Mesh",
    "Place",
    "Print",
    "Region",
    "Results",
    "Session",
    "Solid",
    "StudyError",
    "StudyResults",
    "Surface",
    "Table",
    "Value",
    "function",
    "grid",
    "run",
    "study",
    *_operations.__all__,
]


def __getattr__(name: str) -> Any:
    """What takes long to load is loaded when it is asked for."""
    if name in ("StudyError", "StudyResults", "grid", "study"):
        from . import _study

        return getattr(_study, name)
    if name == "__version__":
        from importlib import metadata

        return metadata.version("virote")
    if name in _operations.SHADOWS:
        # Operations called like functions of Python: `virote.max`, never by `import *`.
        return getattr(_operations, name + "_")
    raise AttributeError(f"module 'virote' has no attribute {name!r}")
