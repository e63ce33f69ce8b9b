"""Values on their way to the language and back: ranges, truth values, bytes, and arrays without NumPy."""

from __future__ import annotations

import pickle
import subprocess
import sys

import numpy as np
import pytest
import virote


def test_ranges_are_told_apart_from_points() -> None:
    # The integrals and the least place by hand.
    assert virote.integrate("x => x^2", (0, 3)) == pytest.approx(9)
    assert virote.integrate("x => x^2", over=(0, 3)) == pytest.approx(9)
    assert virote.integrate("x => 1", ("2cm", "50mm")) == pytest.approx(30)
    assert virote.integrate("(x, y) => x * y", [(0, 1), (0, 2)]) == pytest.approx(1)
    assert virote.integrate("(x, y) => x * y", ((0, 1), (0, 2))) == pytest.approx(1)
    assert virote.integrate("p => 1", virote.circle((0, 0), 1)) == pytest.approx(2 * np.pi)
    assert virote.minimize("x => (x - 1)^2", within=(0, 3)) == pytest.approx(1, abs=1e-6)
    best = virote.maximize("u => u.a * (1 - u.b)", within={"a": (0, 2), "b": (0, 1)})
    assert best["a"] == pytest.approx(2) and best["b"] == pytest.approx(0, abs=1e-9)
    with pytest.raises(virote.GeoError, match="over a range"):
        virote.integrate("x => x^2", 3)
    found = virote.Session().run_text("let a = 2..<5\nlet b = [0..1, 0..2]\nlet c = {over: 0cm..3cm}")
    assert found["a"] == virote.Range(2, 5, closed=False) != (2, 5)
    start, end = found["a"]
    assert (start, end, found["a"].closed) == (2, 5, False) and repr(found["a"]) == "Range(2.0, 5.0, closed=False)"
    assert virote.integrate("(x, y) => x * y", found["b"]) == pytest.approx(1)
    assert virote.integrate("x => 1", found["c"]["over"]) == pytest.approx(30)
    assert virote.len(virote.Range(0, 5, closed=False)) == 5
    assert pickle.loads(pickle.dumps(found["a"])) == found["a"]
    assert virote.Range(0, 1) == (0, 1) and hash(virote.Range(0, 1)) == hash((0, 1))
    with pytest.raises(TypeError, match="ends of a range"):
        virote.integrate("x => x", virote.Range("a", 1))  # type: ignore[arg-type]


def test_of_operations_of_one_name_that_with_the_places_is_called() -> None:
    # u v at (1/2, 1)
    for given in [((0, 1), (0, 2)), (virote.Range(0, 1), virote.Range(0, 2))]:
        saddle = virote.parametric("(u, v) => (u, v, u * v)", *given)
        assert saddle(0.5, 1).tolist() == [0.5, 1, 0.5]
    named = virote.parametric("(u, v) => (u, v, u * v)", domain_u=(0, 1), domain_v=(0, 2))
    assert named.domain == ((0, 1), (0, 2))
    assert virote.parametric("t => (t, t^2)", (0, 2)).domain == (0, 2)
    assert virote.parametric(f="t => (t, t^2)", domain=(0, 2)).domain == (0, 2)


def test_prints_have_the_values_of_results() -> None:
    results = virote.Session().run_text("print 180deg, [30deg], (1, 2), 2cm, circle((0, 0), 1), 0..1")
    values = [one.value for one in results.prints]
    assert values[0] == pytest.approx(np.pi) and values[1].tolist() == [pytest.approx(np.pi / 6)]
    assert values[2].tolist() == [1, 2, 0] and values[3] == 20 and values[5] == virote.Range(0, 1)
    assert isinstance(values[4], virote.Curve)
    assert results.prints[3].text == "2cm = 20mm"


@pytest.mark.parametrize("data", [b"abc", bytearray(b"abc")])
def test_bytes_are_no_numbers(data: bytes) -> None:
    for call in (lambda: virote.circle(data, 1), lambda: virote.sum(data), lambda: virote.polyline([data, data])):
        with pytest.raises(TypeError, match="bytes have no meaning"):
            call()


def test_truth_values_are_no_coordinates() -> None:
    for point in [(True, False), [True, 0], np.array([True, False]), np.array([[True, False], [False, True]])]:
        with pytest.raises(virote.GeoError, match="E0301"):
            virote.circle(point, 1)
    for points in [np.array([[True, False], [False, True]]), [(True, False), (False, True)]]:
        with pytest.raises(virote.GeoError, match="E0301"):
            virote.polyline(points)
    with pytest.raises(virote.GeoError, match="E0301"):
        virote.sum(np.array([True, False]))
    assert virote.any([False, True]) is virote.any(np.array([False, True])) is True


WITHOUT_NUMPY = """
import sys
class Missing:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] == "numpy":
            raise {error}
sys.meta_path.insert(0, Missing())
import virote
assert virote.length(virote.circle((0, 0), 1)) > 6
session = virote.Session()
for call in (lambda: session.run_text("let p = (1, 2)")["p"], lambda: virote.circle((0, 0), 1).knots):
    try:
        call()
    except BaseException as err:
        print(type(err).__name__)
"""


@pytest.mark.parametrize(
    "error", ["ModuleNotFoundError(\"No module named 'numpy'\", name='numpy')", "KeyboardInterrupt"]
)
def test_what_keeps_numpy_from_being_loaded_is_raised(error: str) -> None:
    text = WITHOUT_NUMPY.format(error=error)
    found = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
    assert found.stderr == "" and found.stdout.split() == [error.split("(")[0]] * 2
