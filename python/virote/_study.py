"""Studies: one script, many variants of its parameters, on all processors or on a cluster."""

from __future__ import annotations

import json
import math
import os
import sys
import tempfile
import time
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any, TextIO, Union

from . import _virote
from ._pools import Lost, PlanChanged, Pool, StudyError, Task, Variant, pool_of
from ._rows import PartRows, Rows, StudyResults
from ._findings import GeoError
from ._session import ParameterValue, ceilings, default_session, setting

__all__ = ["StudyError", "StudyResults", "grid", "study"]

#: Variants of a batch before it is known how long one takes, and at most.
FIRST_BATCH, MOST_BATCH = 8, 5000
#: Batches for each worker that are handed in at a time.
AHEAD = 2
#: How often a variant may kill the worker that evaluates it.
MOST_KILLS = 2
#: The code of a variant whose worker was lost.
LOST = "worker-lost"

#: A plan: a file, rows as dictionaries, columns by name, or a DataFrame.
Plan = Union[str, "os.PathLike[str]", Iterable[Mapping[str, ParameterValue]], Mapping[str, Any], Any]


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
    variants = _virote.study_plan("grid", script.encode(), ".", None, [f"{name}={given}"])
    chunks = iter(variants.next, [])
    return [values[0][1] for chunk in chunks for _, _, values in chunk]


def study(
    script: str | os.PathLike[str],
    plan: Plan,
    *,
    out: str | os.PathLike[str] | None = None,
    want: str | Sequence[str] = (),
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

    :param plan: a CSV or Parquet file, dictionaries (a list as of :func:`grid`, or whatever gives one after
        the other), a dictionary of columns or a DataFrame. Columns are called like parameters, with units behind them: ``"neck [mm]"``.
    :param out: a folder for Parquet parts as they come. A study that was cut goes on from them. Without it all
        rows are held in memory.
    :param want: the definitions that are results, or the one; without it every named number, text and truth value.
    :param params: values for parameters that do not vary.
    :param workers: processes of a pool of this machine; one for each processor by default.
    :param client: a Dask ``Client``, or any executor with ``submit``, in the place of the pool.
    :param time_limit: seconds after which a variant is stopped, more than 0.
    :param limits: ceilings of a variant by name, such as ``{"memory": 1 << 30}``.
    :param data: files beside the script that workers need, or the one; those that are read are found out as well.
    :param batch_seconds: how long a batch is to take; what a task costs a scheduler is small against it.
    :param progress: whether a bar is drawn; by default where standard error is a terminal.
    """
    if isinstance(batch_seconds, str) or not hasattr(batch_seconds, "__float__"):
        raise TypeError(f"`batch_seconds` is a number of seconds, found {batch_seconds!r}")
    if not batch_seconds > 0:
        raise ValueError(f"a batch takes some time, found {batch_seconds} s")
    seconds = _seconds(time_limit)
    wanted, data = _texts_of("want", want), _texts_of("data", data)
    for what, given in [("params", params), ("limits", limits)]:
        if given is not None and not isinstance(given, Mapping):
            raise TypeError(f"`{what}` are given by name, as {{'name': value}}; found {type(given).__name__}")
    path = Path(script)
    text = path.read_bytes()
    _virote.check_wants(path.name, text, os.fspath(path.parent), wanted)
    settings = [(name, setting(name, value)) for name, value in (params or {}).items()]
    files: dict[str, bytes | None] = {name: (path.parent / name).read_bytes() for name in data}
    task = Task(
        path.name,
        text,
        files,
        settings,
        wanted,
        seconds,
        ceilings(limits),
    )
    with ExitStack() as stack:
        variants = _variants(path, text, plan, stack)
        done = PartRows(out, task, variants.sum) if out is not None else Rows()
        pool = Pool(workers) if client is None else pool_of(client)
        bar = _Bar(variants.n_variants, progress, pool.link)
        stack.callback(bar.close)
        run = _Run(task, path.parent, variants, pool, done, bar, batch_seconds)
        stack.callback(lambda: pool.close(run.under_way))
        try:
            run.finish()
        except PlanChanged:
            if isinstance(done, PartRows):
                done.spoil()
            raise
    return StudyResults(done, done.folder if isinstance(done, PartRows) else None)


def _texts_of(what: str, given: Any) -> list[str]:
    """Names that are given as one text or as several."""
    names = [given] if isinstance(given, str) else given
    if not isinstance(names, Iterable):
        raise TypeError(f"`{what}` is a name or a list of names, found {type(given).__name__}")
    names = list(names)
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"`{what}` is a name or a list of names, found {name!r} in it")
    return names


def _seconds(time_limit: float | None) -> float | None:
    if time_limit is None:
        return None
    if isinstance(time_limit, bool) or not hasattr(time_limit, "__float__"):
        raise TypeError(f"a time limit is a number of seconds, found {time_limit!r}")
    if not 0 < time_limit < 2**63:
        raise ValueError(f"a time limit is some seconds, found {time_limit}; without one it is left out")
    return float(time_limit)


def _variants(path: Path, text: bytes, plan: Plan, stack: ExitStack) -> _virote.PlanVariants:
    """The variants of a plan; what is not in a file goes through one, so that one reader judges all."""
    folder = os.fspath(path.parent)
    if isinstance(plan, (str, os.PathLike)):
        return _virote.study_plan(path.name, text, folder, os.fspath(plan), [])
    scratch = stack.enter_context(tempfile.TemporaryDirectory())
    file = Path(scratch, "plan.csv")
    with file.open("w", encoding="utf-8") as lines:
        lines.writelines(map(_csv_line, _never_blank(_lines(plan, _texts(path)))))
    try:
        return _virote.study_plan(path.name, text, folder, os.fspath(file), [])
    except ValueError as err:
        told = str(err).replace(f"{file}:", "the plan, line ").replace(f"the plan `{file}`", "the plan")
        told = told.replace(f"`{file}`", "the plan")
        raise ValueError(told) from None


def _texts(path: Path) -> frozenset[str]:
    """The parameters of a script that are no numbers; none of a script that cannot be read."""
    try:
        known = default_session().parameters(path)
    except GeoError:
        return frozenset()
    return frozenset(param["name"] for param in known if param["kind"] in ("string", "bool"))


def _lines(plan: Any, texts: frozenset[str]) -> Iterator[list[str | None]]:
    """The header and the rows of a plan, one after the other: it may be longer than memory."""
    if hasattr(plan, "to_dict") and hasattr(plan, "columns"):
        plan = {str(name): plan[name] for name in plan.columns}
    if isinstance(plan, Mapping):
        columns = {name: _column(name, values) for name, values in plan.items()}
        counts = {name: len(values) for name, values in columns.items()}
        if len(set(counts.values())) > 1:
            raise ValueError(f"the columns of the plan are not of one length: {counts}")
        yield list(columns)
        for cells in zip(*columns.values()):
            yield [_cell(name, value, texts) for name, value in zip(columns, cells)]
        return
    names: list[str] = []
    if not isinstance(plan, Iterable):
        raise TypeError(f"a plan is a file, dictionaries, columns by name or a DataFrame, found {type(plan).__name__}")
    for i, row in enumerate(plan):
        if not isinstance(row, Mapping):
            raise TypeError(f"a row of a plan is a dictionary, found {type(row).__name__}")
        if i == 0:
            names = list(row)
            yield [*names]
        if list(row) != names:
            raise ValueError(f"row {i + 1} of the plan gives {list(row)}, the first one {names}")
        yield [_cell(name, value, texts) for name, value in row.items()]
    if not names:
        raise ValueError("the plan has no rows: nothing is to be evaluated")


def _column(name: str, values: Any) -> Sequence[Any]:
    if isinstance(values, str):
        raise TypeError(f"the column {name!r} of the plan is a list of values, found a text")
    return values if hasattr(values, "__len__") else list(values)


def _cell(name: str, value: Any, texts: frozenset[str]) -> str | None:
    # As in files of plans: what is missing is the default, and what is no number is told in its row. In a column of
    # texts a DataFrame has NaN for what is missing.
    if value is None or type(value).__name__ in ("NAType", "NaTType", "MaskedConstant"):
        return None
    try:
        is_finite = math.isfinite(value)
    except (TypeError, ValueError, OverflowError):
        is_finite = True
    if not is_finite and name in texts and value != value:
        return None
    return setting(name, value) if is_finite else str(float(value))


def _never_blank(lines: Iterator[list[str | None]]) -> Iterator[list[str | None]]:
    """Lines of a table; a missing cell of a single column would be a blank line, which is no row."""
    header = next(lines)
    if len(header) > 1:
        yield header
        yield from lines
        return
    is_id = header == ["id"]
    yield header if is_id else [*header, "id"]
    for cells in lines:
        # An empty name is none.
        yield [cells[0] or ""] if is_id else [*cells, None]


def _csv_line(cells: Iterable[str | None]) -> str:
    # In quotes an empty cell is a text; without them it is missing.
    quoted = ["" if cell is None else '"' + cell.replace('"', '""') + '"' for cell in cells]
    return ",".join(quoted) + "\n"


#: Rows, and seconds, that a rate is told from: those of the first moments say little of the others.
TELLING_ROWS, TELLING_SECONDS = 4, 2.0


def _pace(n_new: int, n_left: int, seconds: float) -> str:
    """How many rows come in a second, by three digits that count, and the time that is left."""
    if n_new < TELLING_ROWS or seconds < TELLING_SECONDS:
        return ""
    rate = n_new / seconds
    told = f"{rate:.0f}" if rate >= 99.95 else f"{rate:#.3g}"
    left = n_left / rate
    units = [(86400, "d"), (3600, "h"), (60, "min"), (1, "s")]
    size, unit = next((one for one in units if 2 * one[0] <= left), (1, "s"))
    return f", {told}/s, {left / size:.0f} {unit} left"


class _Bar:
    """A line with how far a study is, at most ten times a second."""

    def __init__(self, n_all: int, is_shown: bool | None, link: str | None) -> None:
        self._stream: TextIO = sys.stderr
        self._is_shown = self._stream.isatty() if is_shown is None else is_shown
        self._all, self._done, self._begun = n_all, 0, time.monotonic()
        self._kept, self._last, self._width = 0, 0.0, 0
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
        filled = 30 * self._done // max(self._all, 1)
        bar = "█" * filled + "░" * (30 - filled)
        pace = _pace(self._done - self._kept, self._all - self._done, now - self._begun)
        text = f"{bar} {self._done} of {self._all} variants{pace}"
        # What was longer before is written over.
        self._stream.write("\r" + text.ljust(self._width))
        self._stream.flush()
        self._width = len(text)

    def close(self) -> None:
        if self._is_shown and self._last:
            self._stream.write("\n")


class _Left:
    """The variants of a plan that have no row yet, read as they are taken."""

    def __init__(self, plan: _virote.PlanVariants, done: list[range]) -> None:
        self._variants = self._read(plan, done)
        self._count = plan.n_variants - sum(map(len, done))
        self._next: Variant | None = None

    @staticmethod
    def _read(plan: _virote.PlanVariants, done: list[range]) -> Iterator[Variant]:
        ranges = iter(done)
        skipped = next(ranges, range(0))
        while chunk := _Left._chunk(plan):
            for variant in chunk:
                while skipped and skipped.stop <= variant[0]:
                    skipped = next(ranges, range(0))
                if variant[0] not in skipped:
                    yield variant

    @staticmethod
    def _chunk(plan: _virote.PlanVariants) -> list[Variant]:
        try:
            return plan.next()
        except ValueError as err:
            # It was right when it was checked.
            raise PlanChanged(str(err)) from None

    def __len__(self) -> int:
        return self._count

    def next_number(self) -> int:
        if self._next is None:
            self._next = next(self._variants, None)
        if self._next is None:
            raise PlanChanged("the plan was changed while the study ran")
        return self._next[0]

    def take(self) -> Variant:
        self.next_number()
        taken, self._next = self._next, None
        assert taken is not None
        self._count -= 1
        return taken


class _Run:
    """A study under way: batches that wait, batches under way, rows that are there."""

    def __init__(
        self,
        task: Task,
        folder: Path,
        plan: _virote.PlanVariants,
        pool: Pool,
        done: Rows,
        bar: _Bar,
        batch_seconds: float,
    ) -> None:
        self.task, self.folder, self.pool, self.done, self.bar = task, folder, pool, done, bar
        self.batch_seconds = batch_seconds
        bar.keep(len(done))
        self.left = _Left(plan, done.ranges())
        self.again: deque[list[Variant]] = deque()
        self.suspects: deque[list[Variant]] = deque()
        self.kills: dict[int, int] = {}
        self.size = FIRST_BATCH
        self.under_way: dict[Any, list[Variant]] = {}

    def finish(self) -> None:
        """Evaluates what has no row yet."""
        while self.left or self.again or self.under_way:
            self._hand_in()
            for future in list(self.pool.wait(self.under_way)):
                if future in self.under_way:
                    self._take(future)
            if self.suspects and not self.under_way:
                self._try_suspects()

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

    def _next_batch(self) -> list[Variant]:
        batch: list[Variant] = []
        # Parts are ranges: what is there already ends a batch.
        while self.left and len(batch) < self.size:
            if batch and self.left.next_number() != batch[-1][0] + 1:
                break
            batch.append(self.left.take())
        return batch

    def _take(self, future: Any) -> None:
        batch = self.under_way.pop(future)
        try:
            rows, missing, seconds = self.pool.result(future)
        except Lost:
            self.suspects.append(batch)
            # What was under way beside it is lost, too.
            if type(self.pool) is Pool:
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

    def _keep(self, batch: list[Variant], rows: list[str]) -> None:
        if isinstance(self.done, PartRows):
            for name, content in self.task.files.items():
                self.done.note(name, content)
        try:
            self.done.add(range(batch[0][0], batch[-1][0] + 1), rows)
        except OSError as err:
            told, kept = err.strerror or err, len(self.done)
            raise StudyError(f"{told}; {kept} rows are kept, and the same call goes on") from err
        self.bar.add(len(rows))

    def _try_suspects(self) -> None:
        """Evaluates batches that lost their worker one by one, halved until the variant is found."""
        self.pool.check_begins()
        while self.suspects:
            batch = self.suspects.popleft()
            self.pool.reset()
            future = self.pool.submit(self.task, batch, alone=True)
            self.under_way[future] = batch
            self.pool.wait([future])
            del self.under_way[future]
            try:
                rows, missing, _ = self.pool.result(future)
            except Lost:
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
