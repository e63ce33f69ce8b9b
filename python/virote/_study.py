"""Studies: one script, many variants of its parameters, on all processors or on a cluster."""

from __future__ import annotations

import hashlib
import json
import os
import sys
import tempfile
import time
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TextIO, Union

from . import _virote
from ._session import ParameterValue, setting

__all__ = ["StudyError", "StudyResults", "grid", "study"]

#: Variants of a batch before it is known how long one takes, and at most.
FIRST_BATCH, MOST_BATCH = 8, 5000
#: Batches for each worker that are handed in at a time.
AHEAD = 2
#: Bytes of data that go along with each batch.
MOST_INLINE = 1 << 20
#: How often a variant may kill the worker that evaluates it.
MOST_KILLS = 2
#: The code of a variant whose worker was lost.
LOST = "worker-lost"

#: A plan: a file, rows as dictionaries, columns by name, or a DataFrame.
Plan = Union[str, "os.PathLike[str]", Sequence[Mapping[str, ParameterValue]], Mapping[str, Any], Any]

_Variant = tuple[int, str, list[tuple[str, str]]]


class StudyError(Exception):
    """A study that cannot be carried out, or not to its end."""


class _Task(NamedTuple):
    """All that a worker needs, by content: it may have none of our files."""

    name: str
    text: bytes
    files: dict[str, bytes | None]
    settings: list[tuple[str, str]]
    want: list[str]
    time_limit: float | None
    limits: list[tuple[str, int]]


def _evaluate(task: _Task, variants: list[_Variant]) -> tuple[list[str], list[str], float]:
    """What a worker does: a pure function of what it is given. Rows, missing files, seconds."""
    begin = time.perf_counter()
    rows, missing = _virote.study_batch(
        task.name,
        task.text,
        task.files,
        variants,
        task.settings,
        task.want,
        task.time_limit,
        task.limits,
    )
    return rows, missing, time.perf_counter() - begin


class StudyResults(Sequence[dict[str, Any]]):
    """The rows of a study in the order of its plan, each a dictionary by column titles."""

    def __init__(self, rows: list[str], folder: Path | None) -> None:
        self._rows = rows
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
        found: dict[str, int] = {}
        for row in self:
            if (code := row.get("code")) is not None:
                found[code] = found.get(code, 0) + 1
        return found

    def column(self, title: str) -> list[Any]:
        """A column; ``None`` where a row has nothing in it."""
        rows = list(self)
        if not any(title in row for row in rows):
            titles = list(dict.fromkeys(title for row in rows for title in row))
            raise KeyError(f"no column is called {title!r}; there are {titles}")
        return [row.get(title) for row in rows]

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


def grid(**values: str | Iterable[ParameterValue]) -> list[dict[str, ParameterValue]]:
    """All combinations of values, the last parameter fastest.

    >>> import virote
    >>> len(virote.grid(neck="10mm..20mm:11", closed=[True, False]))
    22
    """
    import itertools

    lists = [_spread(name, given) for name, given in values.items()]
    return [dict(zip(values, combination)) for combination in itertools.product(*lists)]


def _spread(name: str, given: str | Iterable[ParameterValue]) -> list[ParameterValue]:
    if not isinstance(given, str):
        return list(given)
    # The reader of `--vary`, for a script that has this one parameter.
    kind = "0deg" if any(unit in given for unit in ("deg", "rad", "turn")) else "0mm"
    bare = not any(c.isalpha() for c in given)
    script = f"param {name} = {'0' if bare else kind}"
    variants, _ = _virote.study_plan("grid", script.encode(), ".", None, [f"{name}={given}"])
    return [values[0][1] for _, _, values in variants]


def study(
    script: str | os.PathLike[str],
    plan: Plan,
    *,
    out: str | os.PathLike[str] | None = None,
    want: Sequence[str] = (),
    params: Mapping[str, ParameterValue] | None = None,
    workers: int | None = None,
    client: Any = None,
    time_limit: float | None = None,
    limits: Mapping[str, int] | None = None,
    data: Iterable[str] = (),
    batch_seconds: float = 1.0,
    progress: bool | None = None,
) -> StudyResults:
    """Evaluates a script for each row of a plan.

    >>> import virote, tempfile, pathlib
    >>> script = pathlib.Path(tempfile.mkdtemp(), "square.geo")
    >>> _ = script.write_text("param a = 1mm  let area = a^2")
    >>> rows = virote.study(script, [{"a": "2mm"}, {"a": "3mm"}], workers=1)
    >>> rows.column("area [mm^2]")
    [4.0, 9.0]

    :param plan: a CSV or Parquet file, a list of dictionaries (see :func:`grid`), a dictionary of columns
        or a DataFrame. Columns are called like parameters, with units behind them: ``"neck [mm]"``.
    :param out: a folder for Parquet parts as they come. A study that was cut goes on from them.
    :param want: the definitions that are results; without it every named number, text and truth value.
    :param params: values for parameters that do not vary.
    :param workers: processes of a pool of this machine; one for each processor by default.
    :param client: a Dask ``Client``, or any executor with ``submit``, in the place of the pool.
    :param time_limit: seconds after which a variant is stopped.
    :param limits: ceilings of a variant by name, such as ``{"memory": 1 << 30}``.
    :param data: files beside the script that workers need; those that are read are found out as well.
    :param batch_seconds: how long a batch is to take; what a task costs a scheduler is small against it.
    :param progress: whether a bar is drawn; by default where standard error is a terminal.
    """
    if not batch_seconds > 0:
        raise ValueError(f"a batch takes some time, found {batch_seconds} s")
    path = Path(script)
    text = path.read_bytes()
    variants, plan_sum = _variants(path, text, plan)
    settings = [(name, setting(name, value)) for name, value in (params or {}).items()]
    files = {name: (path.parent / name).read_bytes() for name in data}
    task = _Task(
        path.name,
        text,
        dict(files),
        settings,
        list(want),
        time_limit,
        list((limits or {}).items()),
    )
    parts = _Parts(out, task, plan_sum) if out is not None else None
    pool = _Pool(workers) if client is None else _pool_of(client)
    bar = _Bar(len(variants), progress, pool.link)
    run = _Run(task, path.parent, variants, pool, parts, bar, batch_seconds)
    try:
        rows = run.rows()
    finally:
        pool.close()
        run.bar.close()
    return StudyResults(rows, parts.folder if parts else None)


def _variants(path: Path, text: bytes, plan: Plan) -> tuple[list[_Variant], str]:
    """The variants of a plan; what is not in a file goes through one, so that one reader judges all."""
    folder = os.fspath(path.parent)
    if isinstance(plan, (str, os.PathLike)):
        return _virote.study_plan(path.name, text, folder, os.fspath(plan), [])
    columns = _columns(plan)
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch, "plan.csv")
        lines = [_csv_line(columns)]
        lines += [_csv_line(row) for row in zip(*columns.values())]
        file.write_text("".join(lines), encoding="utf-8")
        try:
            return _virote.study_plan(path.name, text, folder, os.fspath(file), [])
        except ValueError as err:
            told = str(err).replace(f"{file}:", "the plan, line ").replace(f"the plan `{file}`", "the plan")
            told = told.replace(f"`{file}`", "the plan")
            raise ValueError(told) from None


def _columns(plan: Any) -> dict[str, list[str]]:
    if hasattr(plan, "to_dict") and hasattr(plan, "columns"):
        plan = {str(name): list(plan[name]) for name in plan.columns}
    if isinstance(plan, Mapping):
        columns = {name: _cells(name, values) for name, values in plan.items()}
        counts = {name: len(cells) for name, cells in columns.items()}
        if len(set(counts.values())) > 1:
            raise ValueError(f"the columns of the plan are not of one length: {counts}")
        return columns
    rows = list(plan)
    if not rows:
        raise ValueError("the plan has no rows: nothing is to be evaluated")
    for row in rows:
        if not isinstance(row, Mapping):
            raise TypeError(f"a row of a plan is a dictionary, found {type(row).__name__}")
    names = list(rows[0])
    for i, row in enumerate(rows):
        if list(row) != names:
            raise ValueError(f"row {i} of the plan gives {list(row)}, the first one {names}")
    return {name: _cells(name, [row[name] for row in rows]) for name in names}


def _cells(name: str, values: Any) -> list[str]:
    if isinstance(values, str):
        raise TypeError(f"the column {name!r} of the plan is a list of values, found a text")
    return ["" if value is None else setting(name, value) for value in values]


def _csv_line(cells: Iterable[str]) -> str:
    quoted = ['"' + cell.replace('"', '""') + '"' for cell in cells]
    return ",".join(quoted) + "\n"


class _Parts:
    """Parquet parts in a folder: each has the rows of a range of variants, and is there whole or not."""

    MANIFEST = "study.json"

    def __init__(self, out: str | os.PathLike[str], task: _Task, plan_sum: str) -> None:
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

    def _save(self) -> None:
        path = self.folder / self.MANIFEST
        scratch = path.with_suffix(".tmp")
        scratch.write_text(json.dumps({**self._wanted, "files": self._files}, indent=1) + "\n")
        os.replace(scratch, path)

    def note(self, name: str, content: bytes | None) -> None:
        """Notes a data file; refuses one that is not what it was for the rows that are there."""
        digest = hashlib.sha256(content).hexdigest() if content is not None else "none"
        known = self._files.setdefault(name, digest)
        if known != digest:
            raise StudyError(f"{name} is not what it was for the rows in {self.folder}")
        self._save()

    def kept(self) -> dict[int, str]:
        """Rows that are there, by the numbers of their variants."""
        rows: dict[int, str] = {}
        for path in sorted(self.folder.glob("part-*.parquet")):
            numbers = _numbers(path)
            found = _virote.read_rows(os.fspath(path))
            if len(found) == len(numbers):
                rows.update(zip(numbers, found))
        return rows

    def write(self, numbers: list[int], rows: list[str]) -> None:
        name = f"part-{numbers[0]:09}-{numbers[-1]:09}.parquet"
        _virote.write_rows(os.fspath(self.folder / name), rows)


def _numbers(path: Path) -> range:
    first, last = path.stem.removeprefix("part-").split("-")
    return range(int(first), int(last) + 1)


class _Lost(Exception):
    """A worker was lost with what it was doing."""


class _Pool:
    """Processes of this machine."""

    link: str | None = None

    def __init__(self, workers: int | None) -> None:
        if workers is not None and workers < 1:
            raise ValueError(f"a study has one worker or more, found {workers}")
        self.size = workers or os.cpu_count() or 1
        self._executor: Any = None

    def submit(self, task: _Task, variants: list[_Variant], alone: bool) -> Any:
        import multiprocessing
        from concurrent.futures import ProcessPoolExecutor

        if self._executor is None:
            # Not `fork`: threads of this process may hold locks.
            context = multiprocessing.get_context("spawn")
            size = 1 if alone else self.size
            self._executor = ProcessPoolExecutor(size, mp_context=context)
        return self._executor.submit(_evaluate, task, variants)

    def wait(self, futures: Iterable[Any]) -> Iterable[Any]:
        from concurrent.futures import FIRST_COMPLETED, wait

        return wait(futures, return_when=FIRST_COMPLETED).done

    def result(self, future: Any) -> tuple[list[str], list[str], float]:
        from concurrent.futures.process import BrokenProcessPool

        try:
            return future.result()  # type: ignore[no-any-return]
        except BrokenProcessPool:
            self.reset()
            raise _Lost from None

    def reset(self) -> None:
        if self._executor is not None:
            self._executor.shutdown(wait=False, cancel_futures=True)
            self._executor = None

    def close(self) -> None:
        self.reset()


class _Executor(_Pool):
    """Any executor with ``submit``; it belongs to whoever made it."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self.size = getattr(client, "_max_workers", None) or os.cpu_count() or 1

    def submit(self, task: _Task, variants: list[_Variant], alone: bool) -> Any:
        return self._client.submit(_evaluate, task, variants)

    def result(self, future: Any) -> tuple[list[str], list[str], float]:
        from concurrent.futures import BrokenExecutor

        try:
            return future.result()  # type: ignore[no-any-return]
        except BrokenExecutor as err:
            raise StudyError(f"the executor lost its workers, and takes no more: {err}") from None

    def reset(self) -> None:
        pass


class _Dask(_Pool):
    """A Dask client."""

    def __init__(self, client: Any) -> None:
        self._client = client
        try:
            self.size = max(1, sum(client.nthreads().values()))
        except Exception as err:
            raise StudyError(f"the scheduler does not answer: {err}") from err
        self.link = client.dashboard_link
        self._shipped: tuple[_Task, Any] | None = None

    def submit(self, task: _Task, variants: list[_Variant], alone: bool) -> Any:
        # A few bytes go along with each batch; much data goes to each worker once.
        if sum(len(content or b"") for content in task.files.values()) < MOST_INLINE:
            return self._client.submit(_evaluate, task, variants, pure=False)
        if self._shipped is None or self._shipped[0] is not task:
            self._shipped = (task, self._client.scatter(task, broadcast=True, hash=False))
        return self._client.submit(_evaluate, self._shipped[1], variants, pure=False)

    def wait(self, futures: Iterable[Any]) -> Iterable[Any]:
        import distributed

        wait: Any = distributed.wait
        try:
            return wait(list(futures), return_when="FIRST_COMPLETED").done  # type: ignore[no-any-return]
        except Exception as err:
            raise StudyError(f"the scheduler went away: {err}") from err

    def result(self, future: Any) -> tuple[list[str], list[str], float]:
        from distributed import KilledWorker

        try:
            return future.result()  # type: ignore[no-any-return]
        except KilledWorker:
            raise _Lost from None
        except Exception as err:
            if self._client.status == "running" and not future.cancelled():
                raise
            raise StudyError(f"the scheduler went away: {err}") from err

    def reset(self) -> None:
        pass


def _pool_of(client: Any) -> _Pool:
    if type(client).__module__.partition(".")[0] == "distributed":
        return _Dask(client)
    if not callable(getattr(client, "submit", None)):
        raise TypeError(f"a client has a method `submit`, found {type(client).__name__}")
    return _Executor(client)


class _Bar:
    """A line with how far a study is, at most ten times a second."""

    def __init__(self, n_all: int, is_shown: bool | None, link: str | None) -> None:
        self._stream: TextIO = sys.stderr
        self._is_shown = self._stream.isatty() if is_shown is None else is_shown
        self._all, self._done, self._begun = n_all, 0, time.monotonic()
        self._kept, self._last = 0, 0.0
        if self._is_shown and link:
            self._stream.write(f"dashboard: {link}\n")

    def keep(self, n_rows: int) -> None:
        self._kept = self._done = n_rows

    def add(self, n_rows: int) -> None:
        self._done += n_rows
        now = time.monotonic()
        if not self._is_shown or now - self._last < 0.1 and self._done < self._all:
            return
        self._last = now
        rate = (self._done - self._kept) / max(now - self._begun, 1e-9)
        left = (self._all - self._done) / rate if rate else 0.0
        filled = 30 * self._done // max(self._all, 1)
        bar = "█" * filled + "░" * (30 - filled)
        text = f"\r{bar} {self._done} of {self._all} variants, {rate:.0f}/s, {left:.0f} s left "
        self._stream.write(text)
        self._stream.flush()

    def close(self) -> None:
        if self._is_shown and self._last:
            self._stream.write("\n")


class _Run:
    """A study under way: batches that wait, batches under way, rows that are there."""

    def __init__(
        self,
        task: _Task,
        folder: Path,
        variants: list[_Variant],
        pool: _Pool,
        parts: _Parts | None,
        bar: _Bar,
        batch_seconds: float,
    ) -> None:
        self.task, self.folder, self.pool, self.parts, self.bar = task, folder, pool, parts, bar
        self.batch_seconds = batch_seconds
        self.done: dict[int, str] = parts.kept() if parts else {}
        bar.keep(len(self.done))
        self.numbers = [number for number, _, _ in variants]
        self.left = deque(variant for variant in variants if variant[0] not in self.done)
        self.again: deque[list[_Variant]] = deque()
        self.suspects: deque[list[_Variant]] = deque()
        self.kills: dict[int, int] = {}
        self.size = FIRST_BATCH
        self.under_way: dict[Any, list[_Variant]] = {}

    def rows(self) -> list[str]:
        """All rows in the order of the plan."""
        while self.left or self.again or self.under_way:
            self._hand_in()
            for future in list(self.pool.wait(self.under_way)):
                if future in self.under_way:
                    self._take(future)
            if self.suspects and not self.under_way:
                self._try_suspects()
        return [self.done[number] for number in self.numbers]

    def _hand_in(self) -> None:
        # While there are suspects nothing else is begun, lest it be lost with them.
        while not self.suspects and len(self.under_way) < AHEAD * self.pool.size:
            batch = self.again.popleft() if self.again else self._next_batch()
            if not batch:
                return
            try:
                future = self.pool.submit(self.task, batch, alone=False)
            except Exception as err:
                # A pool says at the next batch that it was broken.
                if type(err).__name__ != "BrokenProcessPool":
                    raise StudyError(f"the workers take no more: {err}") from err
                self.pool.reset()
                future = self.pool.submit(self.task, batch, alone=False)
            self.under_way[future] = batch

    def _next_batch(self) -> list[_Variant]:
        batch: list[_Variant] = []
        # Parts are ranges: what is there already ends a batch.
        while self.left and len(batch) < self.size:
            if batch and self.left[0][0] != batch[-1][0] + 1:
                break
            batch.append(self.left.popleft())
        return batch

    def _take(self, future: Any) -> None:
        batch = self.under_way.pop(future)
        try:
            rows, missing, seconds = self.pool.result(future)
        except _Lost:
            self.suspects.append(batch)
            # What was under way beside it is lost, too.
            if type(self.pool) is _Pool:
                self.suspects.extend(self.under_way.values())
                self.under_way.clear()
            return
        if missing:
            self._ship(missing)
            self.again.append(batch)
            return
        self._keep(batch, rows)
        wanted = int(len(batch) * self.batch_seconds / max(seconds, 1e-6))
        # At the end batches are smaller, but not so small that they are not worth handing in.
        wanted = max(min(wanted, self._share()), wanted // 10)
        self.size = max(1, min(wanted, 4 * self.size, MOST_BATCH))

    def _share(self) -> int:
        """No batch is so large that other workers have nothing to do at the end."""
        return max(1, len(self.left) // (AHEAD * self.pool.size))

    def _ship(self, missing: list[str]) -> None:
        """Sends files along that workers asked for."""
        files = dict(self.task.files)
        for name in missing:
            path = self.folder / name
            files[name] = path.read_bytes() if path.is_file() else None
        self.task = self.task._replace(files=files)

    def _keep(self, batch: list[_Variant], rows: list[str]) -> None:
        numbers = [number for number, _, _ in batch]
        if self.parts:
            for name, content in self.task.files.items():
                self.parts.note(name, content)
            try:
                self.parts.write(numbers, rows)
            except OSError as err:
                kept = len(self.done)
                raise StudyError(f"{err}; {kept} rows are kept, and the same call goes on") from err
        self.done.update(zip(numbers, rows))
        self.bar.add(len(rows))

    def _try_suspects(self) -> None:
        """Evaluates batches that lost their worker one by one, halved until the variant is found."""
        while self.suspects:
            batch = self.suspects.popleft()
            self.pool.reset()
            future = self.pool.submit(self.task, batch, alone=True)
            self.pool.wait([future])
            try:
                rows, missing, _ = self.pool.result(future)
            except _Lost:
                number, id, values = batch[0]
                if len(batch) > 1:
                    half = len(batch) // 2
                    self.suspects.extendleft([batch[half:], batch[:half]])
                elif self.kills.get(number, 0) + 1 < MOST_KILLS:
                    self.kills[number] = self.kills.get(number, 0) + 1
                    self.suspects.appendleft(batch)
                else:
                    self._keep(batch, [_lost_row(id, values)])
                continue
            if missing:
                self._ship(missing)
                self.suspects.appendleft(batch)
            else:
                self._keep(batch, rows)
        self.pool.reset()


def _lost_row(id: str, values: list[tuple[str, str]]) -> str:
    message = f"the worker that evaluated it was killed {MOST_KILLS} times"
    given = ", ".join(f"{name}={text}" for name, text in values)
    row = {"id": json.loads(id), "code": LOST, "message": f"{message} ({given})"}
    return json.dumps({**row, "milliseconds": None}, ensure_ascii=False)


