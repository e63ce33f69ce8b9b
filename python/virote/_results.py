"""What became of a script."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

    from . import _virote
    from ._findings import Check, Diagnostic, Print
    from ._geometry import Mesh, Table

    _Values = Mapping[str, Any]
else:
    _Values = Mapping

__all__ = ["Results"]


class Results(_Values):
    """The values of a script by name, its checks, its prints, its files.

    ``results["tip"]`` is a value: numbers are floats in the document's unit and in radians, points and
    lists of numbers and points are arrays, curves, surfaces, meshes and tables have classes of their own. Arrays are
    read-only, as what became of a script never changes; ``.copy()`` of one may be written to.
    """

    def __init__(self, inner: _virote.Results, script: str, params: dict[str, str]) -> None:
        self._inner = inner
        self._names = inner.names()
        self._values: dict[str, Any] = {}
        self.script = script
        """The script."""
        self.params = params
        """The values that parameters were given, as a script writes them."""

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            if name not in self._names:
                near = self._inner.nearest(name)
                hint = f"; did you mean {near!r}?" if near else ""
                raise KeyError(f"the script defines no {name!r}{hint}")
            from ._geometry import _kept

            self._values[name] = _kept(self._inner.value(name))
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __copy__(self) -> Results:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Results:
        # What became of a script never changes.
        return self

    def __reduce__(self) -> Any:
        raise TypeError(
            "a virote.Results cannot be pickled; send the script and its parameters, or the numbers and texts that are needed"
        )

    def __repr__(self) -> str:
        return f"<virote.Results of {self.script}: {', '.join(self._names)}>"

    def unit(self, name: str) -> str | None:
        """The unit of a definition that is a number, ``"mm^2"`` or ``"rad"``; ``None`` of all else."""
        if name not in self._names:
            self[name]  # tells what was meant
        return self._inner.unit(name)

    @property
    def checks(self) -> list[Check]:
        """The claims of the script, in its order. One that fails is data: see :attr:`failed`."""
        import json

        from ._findings import Check

        return [Check(**one) for one in json.loads(self._inner.checks())]

    @property
    def failed(self) -> list[Check]:
        """The checks that do not hold."""
        return [check for check in self.checks if not check.holds]

    def raise_for_checks(self) -> None:
        """Raises :class:`virote.CheckFailed` if a check does not hold."""
        if failed := self.failed:
            from ._findings import CheckFailed

            raise CheckFailed(failed)

    @property
    def prints(self) -> list[Print]:
        """The printed lines."""
        from ._findings import Print

        return [Print(*one) for one in self._inner.prints()]

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """Every finding: errors, failed checks and warnings."""
        from ._findings import _diagnostic

        return [_diagnostic(text, picture) for text, picture in self._inner.findings()]

    @property
    def tables(self) -> dict[str, Table]:
        """The tables by name."""
        from ._geometry import Table

        return {name: self[name] for name in self._names if isinstance(self[name], Table)}

    @property
    def meshes(self) -> dict[str, Mesh]:
        """The meshes by name."""
        from ._geometry import Mesh

        return {name: self[name] for name in self._names if isinstance(self[name], Mesh)}

    @property
    def exports(self) -> list[str]:
        """The files that :meth:`write` writes, relative to its folder."""
        return self._inner.exports()

    def write(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Writes the files that the script exports below a folder; their paths."""
        from pathlib import Path

        return [Path(path) for path in self._inner.write(os.fspath(folder))]

    def picture(
        self,
        size: tuple[int, int] = (800, 600),
        view: str | None = None,
        only: list[str] | None = None,
    ) -> bytes:
        """A shaded picture in PNG, as ``virote render`` draws it."""
        return bytes(self._inner.picture(list(size), view, only or []))

    def page(self) -> str:
        """A page that shows the model in any browser, with its parameters and analyses."""
        page = self._inner.page()
        if page is None:
            raise ValueError("the script has nothing to show")
        return page

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a notebook shows: the page of the viewer, and the picture where pages are not shown."""
        import base64
        import html

        from ._findings import GeoError

        bundle: dict[str, Any] = {"text/plain": repr(self)}
        try:
            picture = self.picture()
            bundle["image/png"] = base64.b64encode(picture).decode()
            page = html.escape(self.page(), quote=True)
            style = "width: 100%; height: 520px; border: 0"
            bundle["text/html"] = f'<iframe srcdoc="{page}" style="{style}"></iframe>'
        except (GeoError, ValueError):
            # A script without geometry is a table of its names.
            rows = "".join(
                f"<tr><td>{html.escape(name)}</td><td>{html.escape(_short(self[name]))}</td></tr>"
                for name in self._names
            )
            bundle["text/html"] = f"<table>{rows}</table>"
        return bundle


def _short(value: object) -> str:
    text = str(value)
    return text if len(text) <= 80 else text[:79] + "…"
