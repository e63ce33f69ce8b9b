"""Exact freeform curves and surfaces: a declarative language, its kernel, and studies.

>>> import virote
>>> circle = virote.circle((0, 0), 2)
>>> virote.length(circle)  # doctest: +ELLIPSIS
12.56637...
"""

from __future__ import annotations

# What a broken installation lacks, it lacks at once; all else is loaded when it is asked for.
from . import _virote as _virote

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from . import _operations
    from ._findings import (
        Check,
        CheckFailed,
        Diagnostic,
        GeoError,
        GeoWarning,
        Place,
        Print,
        WriteError,
    )
    from ._geometry import (
        Curve,
        Face,
        Frame,
        Function,
        Mesh,
        Range,
        Region,
        Solid,
        Surface,
        Table,
        Value,
    )
    from ._operations import *  # noqa: F403
    from ._results import Results
    from ._session import Session, function, run
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
        "Range",
        "Region",
        "Results",
        "Session",
        "Solid",
        "StudyError",
        "StudyResults",
        "Surface",
        "Table",
        "Value",
        "WriteError",
        "function",
        "grid",
        "run",
        "study",
        *_operations.__all__,
    ]

#: Where names are defined that are no operations.
_HOMES = {
    "_findings": "Check CheckFailed Diagnostic GeoError GeoWarning Place Print WriteError",
    "_geometry": "Curve Face Frame Function Mesh Range Region Solid Surface Table Value",
    "_results": "Results",
    "_session": "Session function run",
    "_study": "StudyError StudyResults grid study",
}


def _home(name: str) -> str | None:
    return next((home for home, names in _HOMES.items() if name in names.split()), None)


def __getattr__(name: str) -> Any:
    """Loads what is asked for."""
    from importlib import import_module

    if home := _home(name):
        value = getattr(import_module(f".{home}", __name__), name)
    elif name == "__version__":
        from importlib import metadata

        value = metadata.version("virote")
    elif name == "__all__":
        own = [name for names in _HOMES.values() for name in names.split()]
        value = sorted(own) + import_module("._operations", __name__).__all__
    elif name.startswith("_"):
        raise AttributeError(f"module 'virote' has no attribute {name!r}")
    else:
        operations = import_module("._operations", __name__)
        if name in operations.SHADOWS:
            # Operations called like functions of Python: `virote.max`, never by `import *`, nor in here.
            return getattr(operations, name + "_")
        if name not in operations.__all__:
            raise AttributeError(f"module 'virote' has no attribute {name!r}")
        value = getattr(operations, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__getattr__("__all__")})
