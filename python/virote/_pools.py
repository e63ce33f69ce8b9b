"""Who evaluates the variants of a study: processes of this machine, any executor, a Dask cluster."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

from . import _virote

#: Bytes of data that go along with each batch.
MOST_INLINE = 1 << 20

#: Of glibc's `mallopt`: the free memory that goes back to the system at once, and the least that is asked of it by itself.
M_TRIM_THRESHOLD, M_MMAP_THRESHOLD = -1, -3
#: The latter by default.
DEFAULT_MMAP_THRESHOLD = 128 << 10
#: Both while variants are evaluated.
KEPT_BYTES = 32 << 20
#: Where the environment says the former.
TRIM_THRESHOLD = "MALLOC_TRIM_THRESHOLD_"

#: A variant: its number, its id as JSON, and values for parameters.
Variant = tuple[int, str, list[tuple[str, str]]]
#: What becomes of a batch: rows, missing files, seconds.
Answer = tuple[list[str], list[str], float]


class StudyError(Exception):
    """A study that cannot be carried out, or not to its end."""


class PlanChanged(StudyError):
    """The plan is not what it was when it was checked."""


class Lost(Exception):
    """A worker was lost with what it was doing."""


class Task(NamedTuple):
    """All that a worker needs, by content: it may have none of our files."""

    name: str
    text: bytes
    files: dict[str, bytes | None]
    settings: list[tuple[str, str]]
    want: list[str]
    time_limit: float | None
    limits: list[tuple[str, int]]


class _KeptMemory:
    """Keeps what a variant frees for the next one, where the environment says otherwise.

    Workers of Dask are begun with ``MALLOC_TRIM_THRESHOLD_`` of 64 kB, by which glibc gives what is free back to the
    system at once, and asks for it again: a third more time for each variant. That holds again behind the last batch
    that is under way.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._n_batches = 0

    def __enter__(self) -> None:
        with self._lock:
            self._n_batches += 1
            if self._n_batches == 1 and (libc := self._glibc()):
                libc.mallopt(M_TRIM_THRESHOLD, KEPT_BYTES)
                libc.mallopt(M_MMAP_THRESHOLD, KEPT_BYTES)

    def __exit__(self, *_: object) -> None:
        with self._lock:
            self._n_batches -= 1
            if self._n_batches == 0 and (libc := self._glibc()):
                libc.mallopt(M_TRIM_THRESHOLD, int(os.environ[TRIM_THRESHOLD]))
                libc.mallopt(M_MMAP_THRESHOLD, DEFAULT_MMAP_THRESHOLD)
                libc.malloc_trim(0)

    @staticmethod
    def _glibc() -> Any:
        """The library of C, if it is one that the environment says that to and nothing else."""
        threshold = os.environ.get(TRIM_THRESHOLD, "")
        if not threshold.isdecimal() or len(threshold) > 9 or "MALLOC_MMAP_THRESHOLD_" in os.environ:
            return None
        if sys.platform != "linux":
            return None
        import ctypes

        libc = ctypes.CDLL(None)
        return libc if hasattr(libc, "mallopt") and hasattr(libc, "malloc_trim") else None


_kept_memory = _KeptMemory()


def evaluate(task: Task, variants: list[Variant]) -> Answer:
    """What a worker does: a pure function of what it is given."""
    begin = time.perf_counter()
    with _kept_memory:
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


def _prepare_worker() -> None:
    """Ctrl-C goes to whoever started the study, who ends the workers; and whose end is theirs."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _begin() -> None:
    """What a worker does that is there."""


def _end_with_parent() -> None:
    import multiprocessing

    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextmanager
def _without_ctrl_c() -> Iterator[None]:
    """Ctrl-C waits while processes are begun, which begin deaf to it."""
    waiting: list[int] = []
    before = signal.getsignal(signal.SIGINT)
    # Only there it can be set, and only one that Python made can be put back.
    can_wait = before is not None and threading.current_thread() is threading.main_thread()
    if can_wait:
        signal.signal(signal.SIGINT, lambda number, _: waiting.append(number))
    can_mask = hasattr(signal, "pthread_sigmask")
    masked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}) if can_mask else None
    try:
        yield
    finally:
        if masked is not None:
            signal.pthread_sigmask(signal.SIG_SETMASK, masked)
        if can_wait:
            signal.signal(signal.SIGINT, before)
            if waiting:
                signal.raise_signal(signal.SIGINT)


class Pool:
    """Processes of this machine."""

    link: str | None = None

    def __init__(self, workers: int | None) -> None:
        if workers is not None and (isinstance(workers, bool) or not hasattr(workers, "__index__")):
            raise TypeError(f"workers are a whole number of processes, found {workers!r}")
        if workers is not None and workers < 1:
            raise ValueError(f"a study has one worker or more, found {workers}")
        self.size = workers or os.cpu_count() or 1
        self._executor: Any = None
        self._begun: set[Any] = set()

    def submit(self, task: Task, variants: list[Variant], alone: bool) -> Any:
        return self._submit(1 if alone else self.size, evaluate, task, variants)

    def _submit(self, size: int, work: Any, *args: Any) -> Any:
        import multiprocessing
        from concurrent.futures import ProcessPoolExecutor

        if self._executor is None:
            # Not `fork`: threads of this process may hold locks.
            context = multiprocessing.get_context("spawn")
            self._executor = ProcessPoolExecutor(size, context, _prepare_worker)
        with _without_ctrl_c():
            future = self._executor.submit(work, *args)
            self._begun.add(future)
            future.add_done_callback(self._begun.discard)
        return future

    def check_begins(self) -> None:
        """Refuses where it is no variant that ends the workers, but that they cannot even begin."""
        from concurrent.futures.process import BrokenProcessPool

        self.reset()
        try:
            self._submit(1, _begin).result()
        except BrokenProcessPool:
            raise StudyError(
                "no process of the pool begins; they read the program that starts the study once more, "
                'which therefore does so below `if __name__ == "__main__":`, and what else it does too'
            ) from None

    def wait(self, futures: Iterable[Any]) -> Iterable[Any]:
        from concurrent.futures import FIRST_COMPLETED, wait

        return wait(futures, return_when=FIRST_COMPLETED).done

    def result(self, future: Any) -> Answer:
        from concurrent.futures.process import BrokenProcessPool

        try:
            return future.result()  # type: ignore[no-any-return]
        except BrokenProcessPool:
            self.reset()
            raise Lost from None

    def reset(self) -> None:
        if self._executor is not None:
            self._executor.shutdown(wait=False, cancel_futures=True)
            self._executor = None

    def close(self, under_way: Iterable[Any]) -> None:
        """Ends the workers, also in the middle of what is still under way."""
        executor, self._executor = self._executor, None
        if executor is None:
            return
        # Also what Ctrl-C kept from being noted as under way. None is cancelled, as the executor gives it up
        # itself when its processes are gone, and is confused by some that are.
        if {*under_way, *self._begun}:
            for process in list((executor._processes or {}).values()):
                process.kill()
            executor.shutdown(wait=True)
        else:
            executor.shutdown(wait=False)


class Executor(Pool):
    """Any executor with ``submit``; it belongs to whoever made it."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self.size = getattr(client, "_max_workers", None) or os.cpu_count() or 1

    def submit(self, task: Task, variants: list[Variant], alone: bool) -> Any:
        return self._client.submit(evaluate, task, variants)

    def result(self, future: Any) -> Answer:
        from concurrent.futures import BrokenExecutor

        try:
            return future.result()  # type: ignore[no-any-return]
        except BrokenExecutor as err:
            raise StudyError(f"the executor lost its workers, and takes no more: {err}") from None

    def check_begins(self) -> None:
        pass

    def reset(self) -> None:
        pass

    def close(self, under_way: Iterable[Any]) -> None:
        for future in under_way:
            # What Ray's recipe gives cannot be taken back.
            if hasattr(future, "cancel"):
                future.cancel()


class Dask(Pool):
    """A Dask client."""

    def __init__(self, client: Any) -> None:
        self._client = client
        try:
            self.size = max(1, sum(client.nthreads().values()))
        except Exception as err:
            raise StudyError(f"the scheduler does not answer: {err}") from err
        self.link = client.dashboard_link
        self._shipped: tuple[Task, Any] | None = None

    def submit(self, task: Task, variants: list[Variant], alone: bool) -> Any:
        # A few bytes go along with each batch; much data goes to each worker once.
        if sum(len(content or b"") for content in task.files.values()) < MOST_INLINE:
            return self._client.submit(evaluate, task, variants, pure=False)
        if self._shipped is None or self._shipped[0] is not task:
            self._shipped = (task, self._client.scatter(task, broadcast=True, hash=False))
        return self._client.submit(evaluate, self._shipped[1], variants, pure=False)

    def wait(self, futures: Iterable[Any]) -> Iterable[Any]:
        import distributed

        wait: Any = distributed.wait
        try:
            return wait(list(futures), return_when="FIRST_COMPLETED").done  # type: ignore[no-any-return]
        except Exception as err:
            raise StudyError(f"the scheduler went away: {err}") from err

    def result(self, future: Any) -> Answer:
        from distributed import KilledWorker

        try:
            return future.result()  # type: ignore[no-any-return]
        except KilledWorker:
            raise Lost from None
        except Exception as err:
            if self._client.status == "running" and not future.cancelled():
                raise
            raise StudyError(f"the scheduler went away: {err}") from err

    def check_begins(self) -> None:
        pass

    def reset(self) -> None:
        pass

    def close(self, under_way: Iterable[Any]) -> None:
        unwanted = list(under_way)
        if unwanted and self._client.status == "running":
            self._client.cancel(unwanted)


def pool_of(client: Any) -> Pool:
    """What evaluates for a client."""
    if type(client).__module__.partition(".")[0] == "distributed":
        return Dask(client)
    if not callable(getattr(client, "submit", None)):
        raise TypeError(f"a client has a method `submit`, found {type(client).__name__}")
    return Executor(client)
