"""Findings of a script: errors as exceptions, warnings and checks as data."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from ._results import Results

__all__ = [
    "Check",
    "CheckFailed",
    "Diagnostic",
    "GeoError",
    "GeoWarning",
    "Place",
    "Print",
    "WriteError",
]


class Place(NamedTuple):
    """A place in a script that a finding is about."""

    file: str | None
    """The script, as it was named."""
    line: int | None
    """Its line, from 1."""
    column: int | None
    """Its column, from 1."""
    text: str
    """What is said of it."""


class Diagnostic(NamedTuple):
    """A finding: an error, a failed check or a warning."""

    severity: str
    """``"error"``, ``"failure"`` or ``"warning"``."""
    code: str
    """Its stable code, such as ``"E0802"``; ``virote explain E0802`` tells more."""
    message: str
    """What is wrong."""
    places: list[Place]
    """Where; the first is the culprit."""
    hints: list[str]
    """What to do."""
    picture: str
    """What the terminal would show."""

    def __str__(self) -> str:
        return self.picture.rstrip()


class Check(NamedTuple):
    """A claim of a script and how it came out."""

    claim: str
    """The claim as it was written."""
    holds: bool
    """Whether it holds."""
    margin: float | None
    """By how much; negative where it fails. ``None`` where nothing was measured."""
    message: str | None
    """The script's own words for it."""
    file: str | None
    """The script."""
    line: int | None
    """Its line."""
    figures: str
    """How far the sides are apart, in words."""


class Print(NamedTuple):
    """A printed line."""

    source: str
    """The expression as it was written."""
    text: str
    """The line."""
    value: Any
    """The value, as :class:`virote.Results` has those of definitions."""


class GeoWarning(UserWarning):
    """Something that a result needed help with."""


class CheckFailed(Exception):
    """A check of a script failed; see :meth:`virote.Results.raise_for_checks`."""

    def __init__(self, checks: list[Check]) -> None:
        lines = [f"{check.message or check.claim}: {check.figures}" for check in checks]
        super().__init__("\n".join(lines))
        self.checks = checks
        """The checks that failed."""

    def __reduce__(self) -> Any:
        # A process that it was raised in sends it to another one.
        return type(self), (self.checks,), self.__dict__


class GeoError(Exception):
    """An error of a script, or of a call of an operation.

    ``str(error)`` is the message with its hints; :meth:`render` what the terminal would show.
    """

    code: str
    """The stable code, such as ``"E0601"``."""
    message: str
    """What is wrong."""
    places: list[Place]
    """Where in the script; the first is the culprit."""
    hints: list[str]
    """What to do."""
    results: Results | None
    """What no error touched, where a script was run; ``None`` of an error that comes from another process."""
    diagnostics: list[Diagnostic]
    """All findings of the run."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.code = diagnostic.code
        self.message = diagnostic.message
        self.places = diagnostic.places
        self.hints = diagnostic.hints
        self.results = None
        self.diagnostics = [diagnostic]
        self._picture = diagnostic.picture
        super().__init__(diagnostic)

    @classmethod
    def _of(cls, text: str, picture: str) -> GeoError:
        return cls(_diagnostic(text, picture))

    def __reduce__(self) -> Any:
        # Values stay in the process that made them.
        return type(self), self.args, {**self.__dict__, "results": None}

    def __copy__(self) -> GeoError:
        # Within a process they need not be left behind.
        make, args, state = self.__reduce__()
        made: GeoError = make(*args)
        made.__setstate__({**state, "results": self.results})
        return made

    def __deepcopy__(self, _: Any) -> GeoError:
        return self.__copy__()

    def render(self) -> str:
        """What the terminal would show: the place in the script, and what to do."""
        return self._picture

    def __str__(self) -> str:
        place = self.places[0] if self.places else None
        where = f" ({place.file}:{place.line})" if place and place.file and place.line else ""
        return "\n".join([f"[{self.code}] {self.message}{where}", *self.hints])


class WriteError(GeoError, OSError):
    """A file that the system does not let be written; an ``OSError`` with its ``errno``, too."""

    @classmethod
    def _of_system(cls, text: str, picture: str, number: int | None) -> WriteError:
        error = cls(_diagnostic(text, picture))
        error.errno = number
        error.strerror = error.message
        return error

    def __reduce__(self) -> Any:
        made, args, state = super().__reduce__()
        return made, args, {**state, "errno": self.errno, "strerror": self.strerror}


def _diagnostic(text: str, picture: str) -> Diagnostic:
    import json

    found = json.loads(text)
    places = [
        Place(one.get("file"), one.get("line"), one.get("column"), one.get("text") or "")
        for one in found.get("labels", [])
    ]
    return Diagnostic(
        found["severity"], found["code"], found["message"], places, list(found["hints"]), picture
    )


def _warn(text: str) -> None:
    import warnings

    warnings.warn(text, GeoWarning, stacklevel=3)
