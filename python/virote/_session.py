"""Sessions: scripts evaluated with values for their parameters."""

from __future__ import annotations

import os
from collections.abc import Mapping

from . import _virote

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

    from ._geometry import Function
    from ._results import Results

__all__ = ["Session", "default_session", "function", "run"]

#: What a parameter can be given: ``"12m"``, ``7``, ``True``.
ParameterValue = str | float | bool


def setting(name: str, value: object) -> str:
    """A value for a parameter as a script would write it."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or type(value).__name__ in ("bool", "bool_"):
        return "true" if value else "false"
    if not hasattr(value, "__float__") or (hasattr(value, "__len__") and not hasattr(value, "item")):
        kind = type(value).__name__
        raise TypeError(f"the parameter {name!r} is a number, a text or a truth value, found {kind}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        kind = type(value).__name__
        raise TypeError(f"the parameter {name!r} is one number, found {kind}") from None
    except OverflowError:
        raise ValueError(f"the parameter {name!r} is larger than any number of the language") from None
    if number != number or number in (float("inf"), -float("inf")):
        raise ValueError(f"the parameter {name!r} is {number}; numbers are finite")
    return str(int(number)) if number.is_integer() and abs(number) < 2**53 else repr(number)


def ceilings(limits: Mapping[str, int] | None) -> list[tuple[str, int]]:
    """Limits by name; what is beyond all of them is left to the library, which tells how far each goes."""
    for name, most in (limits or {}).items():
        if not hasattr(most, "__index__") or most < 0:
            raise ValueError(f"the limit {name!r} is a whole number of 0 or more, found {most!r}")
    return [(name, min(most.__index__(), 2**64 - 1)) for name, most in (limits or {}).items()]


class Session:
    """Evaluates scripts, and remembers what it evaluated: a run does only what changed.

    >>> import virote
    >>> session = virote.Session()
    >>> results = session.run_text("param n = 2  let area = n^2 * 1mm^2", {"n": 3})
    >>> results["area"]
    9.0

    A session may be used from several threads, one run at a time; sessions beside one another run
    beside one another, because the interpreter's lock is released meanwhile. Ctrl-C ends a run.

    :param threads: how many threads one run may use; it changes no result.
    :param limits: ceilings by name, such as ``{"steps": 1_000_000}``; ``virote run --help`` lists them.
    """

    def __init__(self, threads: int = 1, limits: Mapping[str, int] | None = None) -> None:
        if not hasattr(threads, "__index__"):
            raise TypeError(f"threads are a whole number, found {threads!r}")
        if threads < 1:
            raise ValueError(f"a session has one thread or more, found {threads}")
        self._inner = _virote.Session(ceilings(limits), threads)

    def run(
        self,
        script: str | os.PathLike[str],
        params: Mapping[str, ParameterValue] | None = None,
    ) -> Results:
        """Evaluates the script in a file.

        :raises GeoError: where the script has an error; ``error.results`` has what it does not touch.
        :raises KeyError: for a parameter that the script does not have.
        """
        from pathlib import Path

        path = Path(script)
        return self._run(path.name, path.read_bytes(), path.parent, params)

    def run_text(
        self,
        text: str,
        params: Mapping[str, ParameterValue] | None = None,
        folder: str | os.PathLike[str] = ".",
    ) -> Results:
        """Evaluates a script given as text, whose files lie in ``folder``."""
        if not isinstance(text, str):
            raise TypeError(f"a script is a text, found {type(text).__name__}")
        return self._run("<text>", text.encode(), folder, params)

    def _run(
        self,
        name: str,
        text: bytes,
        folder: str | os.PathLike[str],
        params: Mapping[str, ParameterValue] | None,
    ) -> Results:
        from ._results import Results

        if params is not None and not isinstance(params, Mapping):
            raise TypeError(f"parameters are given by name, as {{'span': '12m'}}; found {type(params).__name__}")
        given = {key: setting(key, value) for key, value in (params or {}).items()}
        inner = self._inner.run(name, text, os.fspath(folder), list(given.items()))
        results = Results(inner, name, given)
        error = inner.error()
        if error is not None:
            error.results = results
            error.diagnostics = results.diagnostics
            raise error
        return results

    def parameters(self, script: str | os.PathLike[str]) -> list[dict[str, Any]]:
        """The parameters of a script: name, kind, unit, default, range, step, choices, label, docs."""
        import json
        from pathlib import Path

        path = Path(script)
        text = self._inner.parameters(path.name, path.read_bytes(), os.fspath(path.parent))
        return json.loads(text)["parameters"]  # type: ignore[no-any-return]

    def _call(self, function: Any, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
        return self._inner.call(function, args, named, os.getcwd())


_default: Session | None = None


def default_session() -> Session:
    """The session of :func:`virote.run` and of the operations."""
    global _default
    if _default is None:
        _default = Session()
    return _default


def run(
    script: str | os.PathLike[str], params: Mapping[str, ParameterValue] | None = None
) -> Results:
    """Evaluates the script in a file; the short form of :meth:`Session.run`."""
    return default_session().run(script, params)


def function(text: str) -> Function:
    """A function of the language from its text.

    >>> import virote
    >>> parabola = virote.parametric(virote.function("t => (t, t^2)"), (0, 1))
    >>> parabola(0.5).tolist()
    [0.5, 0.25, 0.0]
    """
    from ._geometry import Function

    found = default_session().run_text(f"let f = {text}")["f"]
    if not isinstance(found, Function):
        raise TypeError(f"{text!r} is no function; write `t => (t, t^2)`")
    return found


def _called(name: str, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """Calls an operation; what was left out stays out."""
    given = {label: value for label, value in named.items() if value is not None}
    return default_session()._call(name, args, given)


def _called_for(columns: int, name: str, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """The same of an operation that answers with numbers or points: an array also where there are none."""
    found = _called(name, args, named)
    if isinstance(found, list) and not found:
        import numpy as np

        return np.empty((0, columns) if 1 < columns else 0)
    return found
