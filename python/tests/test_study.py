"""Studies in Python: rows, resuming, lost workers, a Dask cluster."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import virote

SCRIPT = """
param width = 10mm in 1mm..30mm
param n = 1
let area = width^2
let double = 2 * n
check width < 20mm
"""


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "a.geo"
    path.write_text(SCRIPT)
    return path


def test_every_plan_gives_the_same_rows(script: Path, tmp_path: Path) -> None:
    rows = virote.grid(width="10mm..30mm:3", n=[1, 2])
    assert rows[1] == {"width": "10mm", "n": 2}
    columns = {"width [cm]": [1, 1, 2, 2, 3, 3], "n": [1, 2] * 3}
    plan = tmp_path / "plan.csv"
    plan.write_text("width,n\n10,1\n10,2\n20mm,1\n20mm,2\n3cm,1\n3cm,2\n")
    found = []
    for one in (rows, columns, plan):
        results = virote.study(script, one, workers=1, progress=False)
        found.append([{k: v for k, v in row.items() if k != "milliseconds"} for row in results])
    assert found[0] == found[1] == found[2]
    assert found[0][3]["area [mm^2]"] == 400 and found[0][3]["check 6: width < 20mm"] is False
    assert [row["id"] for row in found[0]] == [1, 2, 3, 4, 5, 6]


def test_texts_are_taken_as_they_stand(tmp_path: Path) -> None:
    path = tmp_path / "a.geo"
    path.write_text('param name = "x"\nlet told = "[{name}]"\n')
    for plan in ([{"name": " c "}, {"name": ""}, {"name": None}], {"name": [" c ", "", None]}):
        rows = virote.study(path, plan, workers=1, want="told", progress=False)
        assert list(rows.column("told")) == ["[ c ]", "[]", "[x]"]


def test_dataframes_are_plans_and_results(script: Path) -> None:
    pd = pytest.importorskip("pandas")
    plan = pd.DataFrame({"id": ["a", "b"], "width [mm]": [5.0, 50.0], "n": [1, 2]})
    results = virote.study(script, plan, workers=1, want=["double"], progress=False)
    frame = results.to_pandas()
    assert list(frame["id"]) == ["a", "b"] and "area [mm^2]" not in frame
    assert results.errors == {"E0802": 1} and frame["double"][0] == 2
    assert repr(results) == "<virote.StudyResults: 2 rows, with errors: 1 of E0802>"


@pytest.mark.parametrize(
    ("plan", "raised", "told"),
    [
        ([], ValueError, "no rows"),
        ([{"widht": 1}], ValueError, "did you mean `width`"),
        ([{"n": 1}, {"width": 2}], ValueError, "row 2 of the plan"),
        ([1], TypeError, "dictionary"),
        ({"n": [1, 2], "width": [1]}, ValueError, "not of one length"),
        ({"n": "1..2:3"}, TypeError, "list of values"),
        ({"width [deg]": [1]}, ValueError, "in deg"),
        ("nowhere.csv", ValueError, "cannot read"),
    ],
)
def test_plans_with_mistakes_are_told(script: Path, plan, raised: type, told: str) -> None:
    with pytest.raises(raised, match=told):
        virote.study(script, plan, workers=1, progress=False)


def test_what_is_asked_wrongly_is_told(script: Path, tmp_path: Path) -> None:
    plan = [{"n": 1}]
    with pytest.raises(ValueError, match="one worker or more"):
        virote.study(script, plan, workers=0)
    with pytest.raises(ValueError, match="some time"):
        virote.study(script, plan, batch_seconds=float("nan"))
    for limit in (0, -1, float("nan"), 1e300):
        with pytest.raises(ValueError, match="a time limit is some seconds"):
            virote.study(script, plan, time_limit=limit)
    with pytest.raises(TypeError, match="a number of seconds, found '1s'"):
        virote.study(script, plan, time_limit="1s")
    for want in ("aera", ["double", "aera"]):
        with pytest.raises(ValueError, match="defines no `aera`; did you mean `area`"):
            virote.study(script, plan, want=want)
    with pytest.raises(ValueError, match="'memory' is a whole number"):
        virote.study(script, plan, limits={"memory": -1})
    for wrong, told in [
        ({"workers": "a"}, "workers are a whole number of processes, found 'a'"),
        ({"workers": 2.5}, "workers are a whole number"),
        ({"workers": True}, "workers are a whole number"),
        ({"batch_seconds": "1"}, "`batch_seconds` is a number of seconds"),
        ({"time_limit": True}, "a number of seconds, found True"),
        ({"want": 3}, "`want` is a name or a list of names, found int"),
        ({"want": [3]}, "`want` is a name or a list of names, found 3 in it"),
        ({"data": 3}, "`data` is a name or a list of names"),
        ({"params": [("n", 1)]}, "`params` are given by name"),
        ({"limits": "memory"}, "`limits` are given by name"),
    ]:
        with pytest.raises(TypeError, match=told):
            virote.study(script, plan, **wrong)
    with pytest.raises(TypeError, match="a plan is a file, dictionaries"):
        virote.study(script, 3)
    with pytest.raises(TypeError, match="method `submit`"):
        virote.study(script, plan, client=3)
    with pytest.raises(ValueError, match="a folder for the parts"):
        virote.study(script, plan, out=tmp_path / "r.csv", workers=1)
    (tmp_path / "full").mkdir()
    (tmp_path / "full/mine").write_text("")
    with pytest.raises(virote.StudyError, match="holds no study"):
        virote.study(script, plan, out=tmp_path / "full", workers=1)
    with pytest.raises(FileNotFoundError):
        virote.study(tmp_path / "nowhere.geo", plan)
    script.write_text("param n = ")
    with pytest.raises(ValueError, match="a.geo"):
        virote.study(script, plan)


def test_one_wanted_definition_may_stand_alone(script: Path) -> None:
    with ThreadPoolExecutor(1) as pool:
        results = virote.study(script, [{"n": 3}], want="double", client=pool, time_limit=60)
    assert results.column("double") == [6] and "area [mm^2]" not in results[0]


def test_what_is_missing_is_the_default_and_what_is_no_number_is_told(
    script: Path, tmp_path: Path
) -> None:
    pd = pytest.importorskip("pandas")
    pa = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    nan = float("nan")
    parquet.write_table(pa.table({"n": pa.array([2.0, None, nan])}), tmp_path / "p.parquet")
    (tmp_path / "p.csv").write_text('n\n2\n""\nnan\n')
    with ThreadPoolExecutor(1) as pool:
        for plan in (
            tmp_path / "p.parquet",
            tmp_path / "p.csv",
            [{"n": 2}, {"n": None}, {"n": nan}],
            {"n": [np.float32(2), np.ma.masked, np.float32(nan)]},
            pd.DataFrame({"n": pd.Series([2, pd.NA, nan], dtype=object)}),
        ):
            results = virote.study(script, plan, client=pool, progress=False)
            assert results.column("double") == [4, 2, None], plan
            assert results.column("code") == [None, None, "E0802"], plan
        infinite = virote.study(script, [{"n": float("inf")}], client=pool, progress=False)
    assert infinite.errors == {"E0802": 1}


def test_decimals_of_files_are_numbers(script: Path, tmp_path: Path) -> None:
    pa = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    widths = [Decimal("2.50"), Decimal("-3.25"), None]
    for digits in (9, 18, 38):
        column = pa.array(widths, pa.decimal128(digits, 2))
        parquet.write_table(pa.table({"width [mm]": column}), tmp_path / "p.parquet")
        with ThreadPoolExecutor(1) as pool:
            results = virote.study(script, tmp_path / "p.parquet", client=pool, progress=False)
        assert results.column("area [mm^2]") == [6.25, None, 100] and results.errors == {"E0802": 1}
    for value in (Decimal("1.5"), Fraction(3, 2)):
        with ThreadPoolExecutor(1) as pool:
            results = virote.study(script, [{"width": value}], client=pool, progress=False)
        assert results.column("area [mm^2]") == [2.25]


def test_a_damaged_part_is_told_with_what_heals_it(script: Path, tmp_path: Path) -> None:
    plan, out = virote.grid(n=range(5)), tmp_path / "out"
    with ThreadPoolExecutor(1) as pool:
        virote.study(script, plan, out=out, client=pool, progress=False)
        part = sorted(out.glob("part-*.parquet"))[0]
        part.write_bytes(part.read_bytes()[:50])
        with pytest.raises(virote.StudyError, match=f"{part.name} is damaged .*; remove it"):
            virote.study(script, plan, out=out, client=pool, progress=False)
        part.unlink()
        again = virote.study(script, plan, out=out, client=pool, progress=False)
    assert again.column("double") == [0, 2, 4, 6, 8]


def test_data_goes_along(tmp_path: Path) -> None:
    (tmp_path / "part.geo").write_text("let size = 3")
    (tmp_path / "d.csv").write_text("x\n5\n")
    script = tmp_path / "a.geo"
    script.write_text('import "part.geo" as part\nparam n = 1\nlet a = n * part.size + load("d.csv").x[0]\n')
    out = tmp_path / "out"
    plan = [{"n": n} for n in range(3)]
    results = virote.study(script, plan, out=out, workers=1, progress=False)
    assert results.column("a") == [5, 8, 11]
    (tmp_path / "d.csv").write_text("x\n6\n")
    next(out.glob("part-*")).unlink()
    with pytest.raises(virote.StudyError, match="d.csv is not what it was"):
        virote.study(script, plan, out=out, workers=1, progress=False)


def test_parts_are_kept_and_files_written(script: Path, tmp_path: Path) -> None:
    plan = virote.grid(n=range(100))
    out = tmp_path / "out"
    first = virote.study(script, plan, out=out, client=ThreadPoolExecutor(2), progress=False)
    parts = sorted(out.glob("part-*.parquet"))
    assert len(parts) > 1 and len(first) == 100
    stamps = [part.stat().st_mtime_ns for part in parts[1:]]
    parts[0].unlink()
    again = virote.study(script, plan, out=out, client=ThreadPoolExecutor(2), progress=False)
    assert [part.stat().st_mtime_ns for part in parts[1:]] == stamps, "they were not made again"
    assert again.column("double") == first.column("double") == [2.0 * n for n in range(100)]
    with pytest.raises(virote.StudyError, match="another plan"):
        virote.study(script, plan[:50], out=out, workers=1)
    script.write_text(SCRIPT + "\n")
    with pytest.raises(virote.StudyError, match="another script"):
        virote.study(script, plan, out=out, workers=1)
    for name in ("r.csv", "r.jsonl", "r.parquet"):
        again.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 1000
    assert again[:2].column("id") == [1, 2]
    with pytest.raises(KeyError, match="no column is called"):
        again.column("nothing")


def test_a_plan_may_be_given_row_by_row(script: Path, tmp_path: Path) -> None:
    rows = ({"n": n, "width": "2mm"} for n in range(3000))
    out = tmp_path / "out"
    results = virote.study(script, rows, out=out, client=ThreadPoolExecutor(2), progress=False)
    assert len(results) == 3000 and results[-1]["double"] == 2 * 2999 and results[7]["double"] == 14
    assert results[2990:].column("id") == list(range(2991, 3001))
    with pytest.raises(IndexError):
        results[3000]
    # What is missing is done, and nothing else.
    parts = sorted(out.glob("part-*.parquet"))
    parts[1].unlink()
    stamps = {part: part.stat().st_mtime_ns for part in parts if part != parts[1]}
    rows = ({"n": n, "width": "2mm"} for n in range(3000))
    again = virote.study(script, rows, out=out, client=ThreadPoolExecutor(2), progress=False)
    assert again.column("double") == [2.0 * n for n in range(3000)]
    assert {part: part.stat().st_mtime_ns for part in stamps} == stamps
    again.write(tmp_path / "all.csv")
    assert len((tmp_path / "all.csv").read_text().splitlines()) == 3001


PEAK = """
import json, resource, sys, tracemalloc
from concurrent.futures import Future
from virote import _pools, _rows, _study

class Quick:
    # As a worker that takes no time.
    _max_workers = 1
    def submit(self, evaluate, task, variants):
        done = Future()
        done.set_result(([json.dumps({"id": n, "a": 1.5}) for n, _, _ in variants], [], 0.01))
        return done

if __name__ == "__main__":
    out, n = sys.argv[1], int(sys.argv[2])
    rows = ({"a": i} for i in range(n))
    results = _study.study(sys.argv[3], rows, out=out, client=Quick(), progress=False)
    assert len(results) == n and results[n - 1]["id"] == n
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="memory is told as Linux does")
def test_memory_does_not_grow_with_the_plan(script: Path, tmp_path: Path) -> None:
    script.write_text("param a = 1")
    peaks = []
    for n in (20_000, 200_000):
        command = [sys.executable, "-c", PEAK, tmp_path / str(n), str(n), script]
        peaks.append(int(subprocess.run(command, capture_output=True, check=True, text=True).stdout))
    assert peaks[1] < peaks[0] + 40_000, peaks


def test_pandas_reads_the_parts(script: Path, tmp_path: Path) -> None:
    pd = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    virote.study(script, virote.grid(n=range(20)), out=tmp_path / "out", workers=1, progress=False)
    frames = [pd.read_parquet(part) for part in sorted((tmp_path / "out").glob("*.parquet"))]
    frame = pd.concat(frames)
    assert list(frame["double"]) == [2.0 * n for n in range(20)]
    assert frame["id"].dtype == "int64" and frame["check 6: width < 20mm"].dtype == "bool"


def test_the_bar_tells_rate_and_time(script: Path, capsys: pytest.CaptureFixture[str]) -> None:
    virote.study(script, virote.grid(n=range(20)), workers=1, progress=True)
    assert "20 of 20 variants" in capsys.readouterr().err
    from virote._study import _pace

    assert _pace(51, 1000, 4.0) == ", 12.8/s, 78 s left"
    assert _pace(40_000, 1_000_000, 2.5) == ", 16000/s, 62 s left"
    assert _pace(4, 400, 40_000.0) == ", 0.000100/s, 46 d left"
    assert _pace(3, 9, 60.0) == _pace(500, 9, 0.1) == "", "what means nothing yet"


def test_a_plan_that_changes_meanwhile_ends_its_study(script: Path, tmp_path: Path) -> None:
    plan, out = tmp_path / "plan.csv", tmp_path / "out"
    text = "n\n" + "".join(f"{i}\n" for i in range(20_000))
    plan.write_text(text)

    class Pool(ThreadPoolExecutor):
        def submit(self, *args, **named):
            plan.write_text("n\n1\n")
            return super().submit(*args, **named)

    with Pool(1) as pool, pytest.raises(virote.StudyError, match="the plan was changed while the study ran"):
        virote.study(script, plan, out=out, client=pool, progress=False)
    # What is there may be of either, also where the plan is put back.
    plan.write_text(text)
    with pytest.raises(virote.StudyError, match="with another plan"):
        virote.study(script, plan, out=out, workers=1, progress=False)


def test_decimal_commas_are_told_with_what_to_write(script: Path, tmp_path: Path) -> None:
    plan = tmp_path / "plan.csv"
    plan.write_text("width [cm];n\n1,2;3\n")
    with pytest.raises(ValueError, match="`width` holds `1,2`, a number with a decimal comma; write `1.2`"):
        virote.study(script, plan, workers=1, progress=False)


def test_a_variant_without_end_is_a_row(script: Path) -> None:
    script.write_text("param n = 1  let a = if n == 2 then sum([for i in 0..<9000000: i % 7]) else n")
    results = virote.study(script, virote.grid(n=[1, 2, 3]), workers=1, time_limit=0.2, progress=False)
    assert results.column("a") == [1, None, 3] and results.errors == {"E0902": 1}


KILLER = """
import os
from virote import _study, _virote

whole = _virote.study_batch

def study_batch(name, text, files, variants, *rest):
    # As the system does when memory is gone.
    if any(("n", "13") in values for _, _, values in variants):
        os.kill(os.getpid(), 9)
    return whole(name, text, files, variants, *rest)

_virote.study_batch = study_batch
"""


def test_a_variant_that_kills_its_worker_is_found(
    script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "sitecustomize.py").write_text(KILLER)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")
    results = virote.study(script, virote.grid(n=range(30)), workers=2, progress=False)
    assert results.errors == {"worker-lost": 1}
    assert results[13]["message"] == "the worker that evaluated it was killed 2 times (n=13)"
    others = [value for value in results.column("double") if value is not None]
    assert others == [2.0 * n for n in range(30) if n != 13]


def test_processes_that_cannot_begin_are_told(script: Path, tmp_path: Path) -> None:
    program = tmp_path / "main.py"
    # Without a look at `__name__` each process would begin a study of its own.
    program.write_text(f"import virote\nvirote.study({str(script)!r}, [{{'n': n}} for n in range(99)], workers=2)\n")
    told = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=60)
    assert told.returncode == 1
    assert "StudyError: no process of the pool begins" in told.stderr


SLOW = "param n = 1\nlet double = 2 * n\nlet slow = sum([for i in 0..<20000: (i * n) % 7])\n"


def test_a_study_that_is_killed_goes_on(script: Path, tmp_path: Path) -> None:
    script.write_text(SLOW)
    out = tmp_path / "out"
    program = f"""
import virote
if __name__ == "__main__":
    virote.study({str(script)!r}, virote.grid(n=range(400)), out={str(out)!r}, workers=1)
"""
    main = tmp_path / "main.py"
    main.write_text(program)
    for n_parts in (2, 4):
        with subprocess.Popen([sys.executable, main], start_new_session=True) as child:
            while len(list(out.glob("part-*.parquet"))) < n_parts:
                time.sleep(0.01)
            os.killpg(child.pid, signal.SIGKILL)
    results = virote.study(script, virote.grid(n=range(400)), out=out, workers=1, progress=False)
    assert results.column("double") == [2.0 * n for n in range(400)]


ENDLESS = "param n = 1\nlet slow = sum([for i in 0..<9000000, j in 0..<9: i * j * n])\n"


def alive(group: int) -> list[str]:
    """The processes of a group that have not ended."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, of = path.read_text().rpartition(")")[2].split()[:3]
            if int(of) == group and state != "Z":
                found.append(path.with_name("cmdline").read_text().replace("\0", " "))
        except OSError:
            continue
    return found


def wait_for(is_so: Callable[[], object]) -> None:
    end = time.monotonic() + 60
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are looked up as Linux has them")
@pytest.mark.parametrize("ended_by", ["interrupt", "ctrl-c", "kill"])
@pytest.mark.parametrize("text", [SLOW, ENDLESS])
def test_ctrl_c_ends_a_study_and_its_workers(
    script: Path, tmp_path: Path, text: str, ended_by: str
) -> None:
    script.write_text(text)
    out = tmp_path / "out"
    program = tmp_path / "main.py"
    program.write_text(f"""
import virote
if __name__ == "__main__":
    virote.study({str(script)!r}, virote.grid(n=range(1, 2001)), out={str(out)!r}, workers=2)
""")
    with subprocess.Popen(
        [sys.executable, program], start_new_session=True, stderr=subprocess.PIPE
    ) as child:
        if text == SLOW:
            wait_for(lambda: 2 < len(list(out.glob("part-*.parquet"))))
        else:
            # The program, two workers, and what looks after their semaphores.
            wait_for(lambda: 4 <= len(alive(child.pid)))
            time.sleep(1)
        if ended_by == "interrupt":
            # As a notebook does, or `kill -INT`.
            child.send_signal(signal.SIGINT)
        elif ended_by == "ctrl-c":
            # As a terminal does: all processes get it.
            os.killpg(child.pid, signal.SIGINT)
        else:
            child.kill()
        _, told = child.communicate(timeout=20)
    wait_for(lambda: not alive(child.pid))
    if ended_by != "kill":
        assert told.count(b"Traceback") == 1 and told.endswith(b"KeyboardInterrupt\n"), told.decode()
    if text == SLOW:
        kept = {part.name: part.stat().st_mtime_ns for part in out.glob("part-*.parquet")}
        results = virote.study(script, virote.grid(n=range(1, 2001)), out=out, workers=2, progress=False)
        assert results.column("double") == [2.0 * n for n in range(1, 2001)]
        assert {name: (out / name).stat().st_mtime_ns for name in kept} == kept, "finished rows stay"


def test_a_dask_cluster_loses_a_worker_and_no_row(script: Path, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    script.write_text(SLOW)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        pids = list(client.run(os.getpid).values())
        assert len(pids) == 2
        out = tmp_path / "out"

        def kill() -> None:
            while len(list(out.glob("part-*.parquet"))) < 2:
                time.sleep(0.01)
            os.kill(pids[0], signal.SIGKILL)

        killer = threading.Thread(target=kill)
        killer.start()
        results = virote.study(script, virote.grid(n=range(600)), out=out, client=client, progress=False)
        killer.join()
        assert results.column("id") == list(range(1, 601)), "each row once"
        assert results.column("double") == [2.0 * n for n in range(600)]


FAULTS = """
import resource, sys
from virote import _pools
task = _pools.Task("a.geo", open(sys.argv[1], "rb").read(), {}, [], [], None, [])
batch = [(i, str(i), [("w", f"{2 + i / 100}mm")]) for i in range(1, 101)]
_pools.evaluate(task, batch)
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
_pools.evaluate(task, batch)
print((resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before) // len(batch))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the habit is that of glibc")
def test_workers_of_dask_keep_memory_from_one_variant_to_the_next(tmp_path: Path) -> None:
    # A list of 3.2 MB for each variant: 780 pages.
    script = tmp_path / "a.geo"
    script.write_text("param w = 2mm  let l = [for i in 1..400000: i * w]  let n = l[7]")
    environment = {**os.environ, "MALLOC_TRIM_THRESHOLD_": "65536"}
    told = subprocess.run(
        [sys.executable, "-c", FAULTS, str(script)], env=environment, capture_output=True, text=True, check=True
    )
    assert int(told.stdout) < 100


def test_a_scheduler_that_goes_away_is_told(script: Path) -> None:
    distributed = pytest.importorskip("distributed")
    script.write_text(SLOW)
    cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None)
    client = distributed.Client(cluster, timeout="5s")
    threading.Timer(1.0, cluster.close).start()
    with pytest.raises(virote.StudyError):
        virote.study(script, virote.grid(n=range(100_000)), client=client, progress=False)
    client.close()


def test_manifests_tell_what_the_parts_are_of(script: Path, tmp_path: Path) -> None:
    virote.study(script, [{"n": 1}], out=tmp_path / "out", workers=1, progress=False)
    manifest = json.loads((tmp_path / "out/study.json").read_text())
    assert manifest["want"] == [] and len(manifest["script"]) == 64
    (tmp_path / "out/study.json").write_text("{")
    with pytest.raises(virote.StudyError, match="not what a study left"):
        virote.study(script, [{"n": 1}], out=tmp_path / "out", workers=1)


def test_a_text_that_a_data_frame_lacks_is_the_default(tmp_path):
    pandas = pytest.importorskip("pandas")
    script = tmp_path / "label.geo"
    script.write_text('param w = 1  param label = "plain"  let told = "{label}!"')
    plan = pandas.DataFrame({"w": [1, 2], "label": ["fine", None]})
    rows = virote.study(script, plan, workers=1, progress=False)
    assert rows.column("told") == ["fine!", "plain!"]
