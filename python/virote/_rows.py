"""The rows of a study: in memory, or in Parquet parts in a folder."""

from __future__ import annotations

import hashlib
import json
import os
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from . import _virote
from ._pools import StudyError, Task


class Rows(Sequence[str]):
    """Rows that are there, by the numbers of their variants, from 1: at first those of earlier runs."""

    def __init__(self) -> None:
        self._rows: dict[int, str] = {}

    def add(self, numbers: range, rows: list[str]) -> None:
        self._rows.update(zip(numbers, rows))

    def ranges(self) -> list[range]:
        """The numbers that are there, in order."""
        return []

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        return self._rows[range(1, len(self) + 1)[index]]

    def __iter__(self) -> Iterator[str]:
        return (self._rows[number] for number in range(1, len(self) + 1))


class PartRows(Rows):
    """Parquet parts: each has the rows of a range of variants, and is there whole or not.

    Only one of them is in memory.
    """

    MANIFEST = "study.json"

    def __init__(self, out: str | os.PathLike[str], task: Task, plan_sum: str) -> None:
        self.folder = Path(out)
        if self.folder.suffix in (".csv", ".jsonl", ".parquet"):
            raise ValueError(
                f"`out` is a folder for the parts of a study, found {str(out)!r}; "
                "write one file with `results.write(...)`"
            )
        self.folder.mkdir(parents=True, exist_ok=True)
        self._files: dict[str, str] = {}
        wanted = {
            "script": hashlib.sha256(task.text).hexdigest(),
            "plan": plan_sum,
            "settings": [list(one) for one in task.settings],
            "want": task.want,
            "time_limit": task.time_limit,
            "limits": [list(one) for one in task.limits],
        }
        manifest = self.folder / self.MANIFEST
        if manifest.exists():
            try:
                kept = json.loads(manifest.read_text())
            except ValueError:
                raise StudyError(f"{manifest} is not what a study left") from None
            differ = [name for name, value in wanted.items() if kept.get(name) != value]
            if differ:
                raise StudyError(
                    f"{self.folder} holds the results of a study with another "
                    f"{' and another '.join(differ)}; take another folder, or remove it"
                )
            self._files = kept.get("files", {})
        elif any(self.folder.iterdir()):
            raise StudyError(f"{self.folder} is not empty, and holds no study")
        self._wanted = wanted
        self._save()
        self._parts = self._kept()
        self._held: tuple[int, list[str]] | None = None
        self._count = sum(map(len, self._parts))

    def _save(self) -> None:
        path = self.folder / self.MANIFEST
        scratch = path.with_suffix(".tmp")
        scratch.write_text(json.dumps({**self._wanted, "files": self._files}, indent=1) + "\n")
        os.replace(scratch, path)

    def spoil(self) -> None:
        """Notes that the plan was changed while its rows were made: no study goes on from them."""
        self._wanted["plan"] = "changed while its rows were made"
        self._save()

    def note(self, name: str, content: bytes | None) -> None:
        """Notes a data file; refuses one that is not what it was for the rows that are there."""
        digest = hashlib.sha256(content).hexdigest() if content is not None else "none"
        known = self._files.get(name)
        if known is None:
            self._files[name] = digest
            self._save()
        elif known != digest:
            raise StudyError(f"{name} is not what it was for the rows in {self.folder}")

    def _kept(self) -> list[range]:
        """The ranges of parts that are whole."""
        found: list[range] = []
        for path in sorted(self.folder.glob("part-*.parquet")):
            first, last = path.stem.removeprefix("part-").split("-")
            numbers = range(int(first), int(last) + 1)
            is_behind = not found or found[-1].stop <= numbers.start
            try:
                n_rows = len(_virote.read_rows(os.fspath(path))) if is_behind else 0
            except OSError as err:
                told = f"{path} is damaged ({err}); remove it, and the same call evaluates its variants again"
                raise StudyError(told) from err
            if n_rows == len(numbers):
                found.append(numbers)
        return found

    def _path(self, numbers: range) -> Path:
        return self.folder / f"part-{numbers[0]:09}-{numbers[-1]:09}.parquet"

    def add(self, numbers: range, rows: list[str]) -> None:
        _virote.write_rows(os.fspath(self._path(numbers)), rows)
        at = bisect_right([part.start for part in self._parts], numbers.start)
        self._parts.insert(at, numbers)
        self._count += len(numbers)
        self._held = None

    def ranges(self) -> list[range]:
        return list(self._parts)

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        number = range(1, len(self) + 1)[index]
        at = bisect_right([part.start for part in self._parts], number) - 1
        if self._held is None or self._held[0] != at:
            self._held = (at, _virote.read_rows(os.fspath(self._path(self._parts[at]))))
        return self._held[1][number - self._parts[at].start]

    def __iter__(self) -> Iterator[str]:
        parts = (_virote.read_rows(os.fspath(self._path(part))) for part in self._parts)
        return chain.from_iterable(parts)


class StudyResults(Sequence[dict[str, Any]]):
    """The rows of a study in the order of its plan, each a dictionary by column titles.

    With a folder of parts they stay there, and are read as they are asked for.
    """

    def __init__(self, rows: Sequence[str], folder: Path | None) -> None:
        self._rows = rows
        self._errors: dict[str, int] | None = None
        self.folder = folder
        """Where the parts are, or ``None``."""

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return StudyResults(self._rows[index], self.folder)
        return json.loads(self._rows[index])

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return (json.loads(row) for row in self._rows)

    @property
    def errors(self) -> dict[str, int]:
        """How many rows have each code of an error."""
        if self._errors is None:
            found: dict[str, int] = {}
            for row in self:
                if (code := row.get("code")) is not None:
                    found[code] = found.get(code, 0) + 1
            self._errors = found
        return dict(self._errors)

    def column(self, title: str) -> list[Any]:
        """A column; ``None`` where a row has nothing in it."""
        cells, is_there = [], False
        for row in self:
            is_there = is_there or title in row
            cells.append(row.get(title))
        if not is_there:
            titles = list(dict.fromkeys(title for row in self for title in row))
            raise KeyError(f"no column is called {title!r}; there are {titles}")
        return cells

    def to_pandas(self) -> Any:
        """The rows as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame(list(self))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the rows into one file: ``.csv``, ``.jsonl`` or ``.parquet``."""
        _virote.write_rows(os.fspath(path), self._rows)

    def __repr__(self) -> str:
        wrong = ", ".join(f"{n} of {code}" for code, n in self.errors.items())
        return f"<virote.StudyResults: {len(self)} rows{', with errors: ' + wrong if wrong else ''}>"
