"""Scripts evaluated: values, checks, files, errors, threads, signals, forks."""

from __future__ import annotations

import copy
import errno
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import virote


def test_values_come_as_python_has_them(wing: Path) -> None:
    results = virote.Session().run(wing, {"span": "12m", "n": 7})
    assert results["area"] == 12_000 * 1000
    assert results["label"] == "wing 7"
    assert results["swept"] is True
    assert results["tip"].tolist() == [6000, 0, 0]
    assert isinstance(results["edge"], virote.Curve)
    assert isinstance(results["skin_of_it"], virote.Surface)
    assert results.params == {"span": "12m", "n": "7"}
    assert "edge" in results and "nothing" not in results
    assert list(results)[:3] == ["span", "n", "swept"]
    assert len(results.prints) == 1 and results.prints[0].source == "area"
    with pytest.raises(KeyError, match="did you mean 'edge'"):
        results["egde"]


def test_a_failed_check_is_data(wing: Path) -> None:
    results = virote.run(wing, {"span": "25m"})
    (check,) = results.checks
    assert not check.holds and check.margin == -5000 and check.message == "not too wide"
    assert results.failed == [check]
    with pytest.raises(virote.CheckFailed, match="not too wide: misses by 5000"):
        results.raise_for_checks()
    virote.run(wing).raise_for_checks()


def test_an_error_is_an_exception_with_all_that_the_terminal_shows(wing: Path) -> None:
    with pytest.raises(virote.GeoError) as caught:
        virote.run(wing, {"span": "2km"})
    error = caught.value
    assert error.code == "E0802"
    assert "outside 1000mm..30000mm" in error.message
    assert error.places[0].line == 2 and error.places[0].file == "wing.geo"
    assert "wing.geo:2" in error.render()
    assert error.results is not None and error.results["n"] == 3
    with pytest.raises(virote.GeoError, match="E0201") as caught:
        virote.Session().run_text("let a = sine(1)")
    assert caught.value.diagnostics[0].severity == "error"


def test_exceptions_go_from_process_to_process(wing: Path) -> None:
    with pytest.raises(virote.GeoError) as caught:
        virote.run(wing, {"span": "2km"})
    error = caught.value
    error.add_note("of the second run")
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is virote.GeoError and again.results is None and error.results is not None
    assert (again.code, again.message, again.places) == ("E0802", error.message, error.places)
    assert str(again) == str(error) and again.render() == error.render()
    assert again.diagnostics == error.diagnostics and again.__notes__ == ["of the second run"]
    with pytest.raises(virote.CheckFailed) as failed:
        virote.run(wing, {"span": "25m"}).raise_for_checks()
    again = pickle.loads(pickle.dumps(failed.value))
    assert str(again) == str(failed.value) and again.checks == failed.value.checks


def test_results_tell_what_to_send_in_their_place() -> None:
    results = virote.Session().run_text("let a = 1")
    with pytest.raises(TypeError, match="send the script and its parameters"):
        pickle.dumps(results)
    assert copy.copy(results)["a"] == copy.deepcopy(results)["a"] == 1


@pytest.mark.skipif(sys.platform != "linux", reason="a folder where nothing is made")
def test_what_the_system_refuses_keeps_its_number(tmp_path: Path) -> None:
    results = virote.Session().run_text('export 1 to "a.json"')
    for folder, number in (("/proc", errno.ENOENT), ("/dev/null", None)):
        with pytest.raises(virote.WriteError) as caught:
            results.write(folder)
        again = pickle.loads(pickle.dumps(caught.value))
        assert type(again) is virote.WriteError and again.code == "E0706"
        assert again.errno == caught.value.errno == number
        assert again.strerror == caught.value.strerror and str(again) == str(caught.value)
    assert "`/dev/null` is a file, not a folder" in str(caught.value)


@pytest.mark.parametrize(
    ("call", "raised", "told"),
    [
        (lambda: virote.Session().run_text(3), TypeError, "a script is a text, found int"),
        (lambda: virote.Session().run_text(b"let a = 3"), TypeError, "found bytes"),
        (lambda: virote.Session(limits={"memory": 1 << 70}), ValueError, "`memory` is from 1 to"),
        (lambda: virote.Session(limits={"memory": "1"}), ValueError, "'memory' is a whole number"),
        (lambda: virote.Session(limits={"memory": -1}), ValueError, "'memory' is a whole number"),
    ],
)
def test_what_a_session_does_not_take(call, raised: type, told: str) -> None:
    with pytest.raises(raised, match=told):
        call()


@pytest.mark.parametrize(
    ("params", "raised", "told"),
    [
        ({"spna": 1}, KeyError, "did you mean `span`"),
        ({"n": float("nan")}, ValueError, "numbers are finite"),
        ({"n": 10**400}, ValueError, "larger than any number"),
        ({"n": [1]}, TypeError, "found list"),
        ({"n": np.array([1.0, 2.0])}, TypeError, "is one number"),
        ({"n": None}, TypeError, "found NoneType"),
        ({"n": {}}, TypeError, "found dict"),
    ],
)
def test_parameters_that_are_none(wing: Path, params: dict, raised: type, told: str) -> None:
    with pytest.raises(raised, match=told):
        virote.run(wing, params)


def test_numbers_of_numpy_are_numbers(wing: Path) -> None:
    given = {"n": np.int64(4), "swept": np.bool_(False), "span": np.float64(5000.0)}
    results = virote.run(wing, given)
    assert (results["n"], results["swept"], results["span"]) == (4, False, 5000)


def test_files_are_written_below_the_folder(wing: Path, tmp_path: Path) -> None:
    written = virote.run(wing).write(tmp_path / "out")
    assert written == [tmp_path / "out/edge.svg", tmp_path / "out/sub/offsets.csv"]
    assert (tmp_path / "out/sub/offsets.csv").read_text().startswith("t,x [mm],who\n0,1,a\n")
    wing.write_text('export 1 to "wing.geo"')
    with pytest.raises(virote.GeoError, match="E07"):
        virote.run(wing).write(tmp_path)


def test_tables_and_meshes_are_arrays(wing: Path) -> None:
    results = virote.run(wing)
    table = results.tables["offsets"]
    assert table.columns == ["t", "x", "who"] and table.units == {"x": "mm"} and len(table) == 3
    assert table["x"].tolist() == [1, 2, 3] and table["who"] == ["a", "b", "c"]
    with pytest.raises(KeyError, match="no column 'y'"):
        table["y"]
    mesh = results.meshes["faces"]
    assert mesh.points.shape[1] == 3 and mesh.triangles.shape[1] == 3
    assert mesh.triangles.dtype == np.uint32 and mesh.triangles.max() < len(mesh.points)
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
    assert mesh.uv.shape == (len(mesh.points), 2)


def test_tables_speak_arrow(wing: Path) -> None:
    pd = pytest.importorskip("pandas")
    pa = pytest.importorskip("pyarrow")
    table = virote.run(wing)["offsets"]
    frame = table.to_pandas()
    assert list(frame.columns) == ["t", "x", "who"] and frame.attrs["units"] == {"x": "mm"}
    assert isinstance(frame, pd.DataFrame)
    arrow = pa.table(table)
    assert arrow.column("who").to_pylist() == ["a", "b", "c"]
    assert arrow.schema.field("x").metadata == {b"unit": b"mm"}


def test_a_notebook_shows_the_picture_and_the_page(wing: Path) -> None:
    bundle = virote.run(wing)._repr_mimebundle_()
    assert bundle["text/html"].startswith("<iframe srcdoc=") and "virote-data" in bundle["text/html"]
    import base64

    assert base64.b64decode(bundle["image/png"]).startswith(b"\x89PNG")
    assert "area" in virote.Session().run_text("let area = 2")._repr_mimebundle_()["text/html"]


def test_numbers_have_units(wing: Path) -> None:
    text = "let a = 2cm^2  let b = 30deg  let c = 1 / 2mm  let d = 3  let e = 1m * 1rad  let s = \"x\""
    results = virote.Session().run_text(text)
    units = {name: results.unit(name) for name in results}
    assert units == {"a": "mm^2", "b": "rad", "c": "mm^-1", "d": None, "e": "mm·rad", "s": None}
    assert results["a"] == 200
    with pytest.raises(KeyError, match="defines no 'f'"):
        results.unit("f")


def test_pictures_are_as_asked(wing: Path) -> None:
    results = virote.run(wing)
    picture = results.picture(size=(80, 60), view="front", only=["edge"])
    assert picture[16:24] == (80).to_bytes(4, "big") + (60).to_bytes(4, "big")
    with pytest.raises(ValueError, match="no view `inside`"):
        results.picture(view="inside")
    with pytest.raises(ValueError, match="defines no `egde`"):
        results.picture(only=["egde"])
    with pytest.raises(ValueError, match="pixels"):
        results.picture(size=(0, 10))


def test_a_session_remembers_what_did_not_change() -> None:
    session = virote.Session()
    slow = "param n = 1  let slow = sum([for i in 0..<400000: i % 7])  let quick = n"
    begin = time.perf_counter()
    session.run_text(slow)
    first = time.perf_counter() - begin
    begin = time.perf_counter()
    for n in range(20):
        assert session.run_text(slow, {"n": n})["quick"] == n
    assert time.perf_counter() - begin < 20 * first


def test_ceilings_are_kept() -> None:
    session = virote.Session(limits={"steps": 1000})
    with pytest.raises(virote.GeoError, match="E0901"):
        session.run_text("let a = sum([for i in 0..<100000: i])")
    with pytest.raises(ValueError, match="no ceiling is called `stpes`"):
        virote.Session(limits={"stpes": 1})
    with pytest.raises(ValueError, match="whole number of 0 or more"):
        virote.Session(limits={"steps": -1})
    with pytest.raises(TypeError, match="threads are a whole number"):
        virote.Session(threads="two")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="by name"):
        session.run_text("param n = 2", [1])  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="one thread or more"):
        virote.Session(threads=0)


ENDLESS = "let a = sum([for i in 0..<9000000, j in 0..<9: i * j])"


def test_other_threads_run_meanwhile_and_share_a_session() -> None:
    session, found = virote.Session(), []

    def work(n: int) -> None:
        found.append(session.run_text("param n = 1  let a = n^2", {"n": n})["a"])

    threads = [threading.Thread(target=work, args=(n,)) for n in range(8)]
    counted = 0
    slow = threading.Thread(
        target=lambda: virote.Session().run_text("let a = sum([for i in 0..<300000: i % 7])")
    )
    slow.start()
    while slow.is_alive():
        counted += 1
    for thread in threads:
        thread.start()
    for thread in [*threads, slow]:
        thread.join()
    assert sorted(found) == [n**2 for n in range(8)]
    assert counted > 100, "the lock of the interpreter was not released"


EVALUATING = """
import numpy as np
c = virote.parametric("t => (sum([for i in 0..<200: i * t]), 0)", (0, 1))
t = np.linspace(0, 1, 10_000_000)
print("ready", flush=True)
c(t)
"""

MESHING = """
net = [[(i, j, i * j % 3) for j in range(9)] for i in range(9)]
s = virote.bspline(net, degree=3)
print("ready", flush=True)
for _ in range(100):
    s.tessellate(tolerance=2e-6)
"""


@pytest.mark.parametrize(
    "work", [f"print('ready', flush=True)\nvirote.Session().run_text({ENDLESS!r})", EVALUATING, MESHING]
)
def test_ctrl_c_ends_work_at_once(work: str) -> None:
    program = f"import virote\n{work}"
    with subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as child:
        assert child.stdout is not None and child.stdout.readline() == b"ready\n"
        time.sleep(0.5)
        begin = time.perf_counter()
        child.send_signal(signal.SIGINT)
        _, err = child.communicate(timeout=60)
    assert b"KeyboardInterrupt" in err
    assert time.perf_counter() - begin < 10


BESIDE = """
import threading, virote
session, found = virote.Session(), {}
text = "let a = [for i in 0..<3000: length(bezier((0, 0), (1, i), (2, 0)))]"
def work():
    found["here"] = len(session.run_text(text)["a"])
    found["there"] = virote.length(virote.bezier([(0, 0), (1, 1), (2, 0)]))
beside = threading.Thread(target=work)
beside.start()
print("ready", flush=True)
try:
    while beside.is_alive():
        session.run_text("let b = 1")
except KeyboardInterrupt:
    beside.join()
    print("interrupted", found["here"], found["there"] > 2, flush=True)
"""


def test_ctrl_c_ends_what_its_own_thread_asked_for() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", BESIDE], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as child:
        assert child.stdout is not None and child.stdout.readline() == b"ready\n"
        time.sleep(0.2)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=60)
    assert out == b"interrupted 3000 True\n", err


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system does not fork")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_has_sessions_that_answer() -> None:
    session = virote.Session()
    holder = threading.Thread(
        target=lambda: session.run_text("let a = sum([for i in 0..<600000: i % 7])")
    )
    holder.start()
    time.sleep(0.05)
    child = os.fork()
    if child == 0:
        signal.alarm(60)
        os._exit(int(session.run_text("let a = 42")["a"]))
    _, status = os.waitpid(child, 0)
    holder.join()
    assert os.waitstatus_to_exitcode(status) == 42


def test_the_command_comes_along() -> None:
    def command(*args: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "virote._command", *args], capture_output=True, text=True
        )

    assert command("--version").stdout.startswith("virote ")
    assert command("explain", "E0602").returncode == 0
    assert command("run", "nowhere.geo").returncode == 3


def test_import_is_quick() -> None:
    # `site` may have loaded some of these before.
    program = """
import sys
before = set(sys.modules)
import virote
heavy = {"numpy", "pandas", "typing", "json", "dataclasses", "inspect", "pathlib", "re"}
print(*sorted(heavy & (set(sys.modules) - before)))
virote.Session
print(*sorted({"numpy", "typing", "json"} & (set(sys.modules) - before)))
"""
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert told.stdout.split() == []


def test_names_are_there_before_they_are_asked_for() -> None:
    program = """
from virote import *
import virote
assert circle is virote.circle and Session is virote.Session and max([1, 2]) == 2
assert set(virote.__all__) <= set(dir(virote)) and "max" not in virote.__all__
assert virote.max([1, 2, 3]) == 3 and virote.__version__
for name in virote.__all__:
    assert getattr(virote, name) is not None
try:
    virote.nothing
except AttributeError as err:
    assert "'nothing'" in str(err)
"""
    assert subprocess.run([sys.executable, "-c", program]).returncode == 0


def test_a_file_that_cannot_be_written_is_told_with_code_and_number(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    script = 'surface s = sphere((0, 0), 1m)\nexport s to "a.stl" with (tolerance = 1mm)\n'
    # A file may have no more bytes than this, as if the disk were full.
    program = f"""
import errno, resource, virote
results = virote.Session().run_text({script!r})
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
try:
    results.write({str(tmp_path)!r})
except virote.WriteError as err:
    assert isinstance(err, virote.GeoError) and isinstance(err, OSError)
    assert err.code == "E0706" and err.errno == errno.EFBIG, (err.code, err.errno)
    assert err.places[0].line == 2 and "cannot write `a.stl`" in str(err) and err.render()
else:
    raise SystemExit("it was written")
"""
    assert resource.RLIMIT_FSIZE is not None
    assert subprocess.run([sys.executable, "-c", program]).returncode == 0
    assert list(tmp_path.iterdir()) == [], "half a file is left"
