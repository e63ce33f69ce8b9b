"""Curves, surfaces and operations over arrays, against closed forms."""

from __future__ import annotations

import copy
import inspect
import pickle
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import virote

MASKED = np.ma.masked_array([[0.0, 0.0], [1.0, 1.0]], mask=[[False, False], [True, False]])
CORNERS = [[(0, 0), (0, 1)], [(1, 0), (1, 1, 1)]]


def test_a_curve_evaluates_over_arrays() -> None:
    c = virote.bezier([(0, 0), (1, 2), (2, 0)])
    t = np.linspace(0, 1, 101)
    points = c(t)
    assert points.shape == (101, 3)
    assert np.allclose(points, np.stack([2 * t, 4 * t * (1 - t), 0 * t], axis=1), atol=1e-14)
    assert c(0.5).shape == (3,) and (c @ 0.5 == c(0.5)).all()
    assert c(t.reshape(101, 1)).shape == (101, 1, 3)
    assert (c(t[::-2]) == points[::-2]).all(), "an array with strides"
    assert (c([0, 1]) == c(np.array([0, 1], dtype=np.int32))).all()
    assert c([]).shape == (0, 3)


def test_derivatives_are_exact() -> None:
    c = virote.bezier([(0, 0), (1, 2), (2, 0)])
    t = np.array([0.0, 0.25, 1.0])
    found = c.derivatives(t, order=3)
    assert found.shape == (3, 4, 3)
    assert np.allclose(found[:, 1, 1], 4 - 8 * t) and np.allclose(found[:, 2, 1], -8)
    assert (found[:, 3] == 0).all()
    with pytest.raises(ValueError, match="order"):
        c.derivatives(0.5, order=-1)
    with pytest.raises(ValueError, match="order"):
        c.derivatives(0.5, order=10**9)
    with pytest.raises(MemoryError, match="GiB"):
        c.derivatives(np.zeros(10**7), order=64)


def test_a_curve_tells_what_it_is_made_of() -> None:
    c = virote.nurbs([(0, 0), (1, 1), (2, 0)], weights=[1, 2, 1], degree=2)
    assert c.degree == 2 and c.rational and c.domain == (0, 1)
    assert c.knots.tolist() == [0, 0, 0, 1, 1, 1]
    assert c.control_points.tolist() == [[0, 0, 0], [1, 1, 0], [2, 0, 0]]
    assert c.weights.tolist() == [1, 2, 1]
    with pytest.raises(ValueError, match=r"to_scipy\(homogeneous=True\)"):
        c.to_scipy()


def test_scipy_has_the_same_curve_and_surface() -> None:
    pytest.importorskip("scipy")
    t = np.linspace(0, 1, 50)
    c = virote.interpolate([(0, 0), (1, 2), (3, 1), (4, 4), (6, 0)])
    assert np.allclose(c(t), c.to_scipy()(t), atol=1e-12)
    grid = [[(i, j, i * j % 3) for j in range(5)] for i in range(6)]
    s = virote.bspline(grid, degree=3)
    u, v = np.meshgrid(t, t, indexing="ij")
    assert np.allclose(s(u, v), s.to_scipy()(np.stack([u, v], axis=-1)), atol=1e-12)


def test_scipy_has_the_homogeneous_spline_of_what_has_weights() -> None:
    pytest.importorskip("scipy")
    t = np.linspace(0, 1, 50)
    circle = virote.circle((1, 2), 3)
    h = circle.to_scipy(homogeneous=True)(t)
    assert h.shape == (50, 4)
    assert np.allclose(h[:, :3] / h[:, 3:], circle(t), atol=1e-14)
    ball = virote.sphere((0, 0), 2)
    with pytest.raises(ValueError, match="this surface has weights"):
        ball.to_scipy()
    u, v = np.meshgrid(t, t, indexing="ij")
    h = ball.to_scipy(homogeneous=True)(np.stack([u, v], axis=-1))
    assert np.allclose(h[..., :3] / h[..., 3:], ball(u, v), atol=1e-14)
    line = virote.line((0, 0), (1, 2))
    assert line.to_scipy(homogeneous=True)(0.5).tolist() == [0.5, 1, 0, 1]


def test_a_notebook_shows_geometry_and_tables() -> None:
    import base64

    ball = virote.sphere((0, 0), 2)
    shown = {
        "curve": virote.circle((0, 0), 2),
        "parametric": virote.parametric("t => (cos(t), sin(t))", (0, 6)),
        "surface": ball,
        "region": virote.region(virote.circle((0, 0), 2)),
        "mesh": ball.tessellate(tolerance=0.1),
        "solid": virote.solid([ball]),
        "face": virote.solid([ball]).faces[0],
    }
    for kind, value in shown.items():
        bundle = value._repr_mimebundle_()
        assert bundle["text/plain"].startswith("<virote."), kind
        assert base64.b64decode(bundle["image/png"]).startswith(b"\x89PNG"), kind
    picture = ball.picture(size=(80, 60), view="front")
    assert picture[16:24] == (80).to_bytes(4, "big") + (60).to_bytes(4, "big")
    with pytest.raises(ValueError, match="no view `inside`"):
        ball.picture(view="inside")
    with pytest.raises(ValueError, match="pixels"):
        ball.picture(size=(0, 60))
    plane = virote.plane((0, 0), (0, 0, 1))
    assert list(plane._repr_mimebundle_()) == ["text/plain"]
    with pytest.raises(ValueError, match="nothing that can be drawn"):
        plane.picture()
    text = 'table t = table({x: [for i in 0..<60: i * 0.1mm], who: [for i in 0..<60: "<{i}>"]})'
    table = virote.Session().run_text(text)["t"]
    bundle = table._repr_mimebundle_()
    assert "<th>x [mm]</th><th>who</th>" in bundle["text/html"]
    assert "<td>0.3</td><td>&lt;3&gt;</td>" in bundle["text/html"]
    assert bundle["text/html"].count("<tr>") == 1 + 50 + 1 and "60 rows × 2 columns" in bundle["text/html"]
    assert bundle["text/plain"].startswith("x [mm]\twho\n0\t<0>\n")


def test_a_surface_evaluates_over_arrays() -> None:
    s = virote.bezier(CORNERS)
    u, v = np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 4), indexing="ij")
    assert np.allclose(s(u, v), np.stack([u, v, u * v], axis=-1), atol=1e-15)
    assert s(0.5, np.linspace(0, 1, 7)).shape == (7, 3), "what broadcasts, does"
    found = s.derivatives(u, v, order=2)
    assert found.shape == (5, 4, 3, 3, 3)
    assert np.allclose(found[..., 1, 1, :], [0, 0, 1]) and np.isnan(found[..., 2, 2, :]).all()
    assert s.degree == (1, 1) and s.control_points.shape == (2, 2, 3)
    assert s.domain == ((0, 1), (0, 1)) and s.weights.tolist() == [[1, 1], [1, 1]]


def test_a_sphere_has_the_curvature_of_its_radius() -> None:
    s = virote.sphere((0, 0), 2)
    u, v = np.linspace(0, 1, 9), np.linspace(0.1, 0.9, 9)
    found = s.curvatures(u, v)
    for name in ("k1", "k2", "mean"):
        assert np.allclose(found[name], -0.5)
    assert np.allclose(found["gaussian"], 0.25)
    assert np.allclose(s.normal(u, v), s(u, v) / 2)
    mesh = s.tessellate(tolerance=0.01)
    assert np.abs(np.linalg.norm(mesh.points, axis=1) - 2).max() < 1e-12
    assert virote.area(s) == pytest.approx(16 * np.pi)


def test_functions_of_the_language_make_curves() -> None:
    c = virote.parametric("t => (cos(t), sin(t), t)", (0, 6))
    t = np.linspace(0, 6, 13)
    assert np.allclose(c(t), np.stack([np.cos(t), np.sin(t), t], axis=1), atol=1e-15)
    assert np.allclose(c.derivatives(t)[:, 1, 0], -np.sin(t))
    with pytest.raises(AttributeError, match="to_nurbs"):
        c.degree
    # It answers when the script is gone, and so does what is made of it.
    assert virote.reversed(c)(0).tolist() == c(6).tolist()
    square = virote.function("x => x^2")
    assert square(3) == 9
    with pytest.raises(virote.GeoError):
        virote.function("t => (")


def test_networks_and_skins() -> None:
    u = [virote.line((0, y, y), (2, y, y)) for y in (0, 1, 2)]
    v = [virote.line((x, 0, 0), (x, 2, 2)) for x in (0, 1, 2)]
    s = virote.gordon(u=u, v=v)
    assert np.allclose(s(0.5, 0.5), [1, 1, 1])
    rings = [virote.circle((0, 0, z), 1 + z) for z in (0, 1, 2)]
    assert virote.skin(rings).degree[0] == 2
    assert virote.loft is not None, "other names are there as well"


def test_units_are_texts_and_points_are_what_looks_like_one() -> None:
    line = virote.line(np.array([0.0, 0.0]), (1, 0, 0))
    turned = virote.rotate(line, "90deg")
    assert np.allclose(turned(1), [0, 1, 0])
    assert np.allclose(virote.translate(line, ("1cm", 0))(0), [10, 0, 0])
    assert virote.distance([0, 0], [3, 4]) == 5
    points = np.arange(12.0).reshape(4, 3)[:, ::-1]
    assert np.allclose(virote.polyline(points).control_points, points), "not contiguous"
    closest = virote.closest(line, (0.25, 1))
    assert closest["t"] == 0.25 and closest["point"].tolist() == [0.25, 0, 0]
    assert virote.max([3, 1, 2]) == 3, "operations called as functions of Python are"


@pytest.mark.parametrize(
    ("call", "raised", "told"),
    [
        (lambda: virote.circle((0, 0), -1), virote.GeoError, "radius must be positive"),
        (lambda: virote.rotate(virote.line((0, 0), (1, 0)), 90), virote.GeoError, "write `90deg`"),
        (lambda: virote.bezier("abc"), virote.GeoError, "E0"),
        (lambda: virote.bezier([(0, 0), (float("nan"), 1)]), ValueError, "nan"),
        (lambda: virote.bezier(np.zeros((2, 2, 2, 2))), virote.GeoError, "E0"),
        (lambda: virote.bezier([[(0, 0), (1, 1)], [(0, 1)]]), virote.GeoError, "E06"),
        (lambda: virote.line((0, 0), object()), TypeError, "no meaning"),
        (lambda: virote.line((0, 0), lambda t: t), TypeError, "no meaning"),
        (lambda: virote.line((0, 0)), TypeError, "missing"),
        (lambda: virote.line((0, 0), (1, 0), nothing=1), TypeError, "nothing"),
        (lambda: virote.nothing, AttributeError, "nothing"),
        (lambda: virote.line((0, 0), (1, 0))(2.0), ValueError, "outside the domain 0..1"),
        (lambda: virote.line((0, 0), (1, 0))([0, np.nan]), ValueError, "NaN"),
        (lambda: virote.line((0, 0), (1, 0))("a"), TypeError, "numbers"),
        (lambda: virote.line((0, 0), (1, 0))([0, 3.0]), ValueError, "at index 1"),
        (lambda: virote.bezier(CORNERS)([0, 1], [0, 0.5, 1]), ValueError, "broadcast"),
        (lambda: pickle.dumps(virote.parametric("t => (t, t^2)", (0, 1))), TypeError, "pickled"),
        (lambda: pickle.dumps(virote.frame_of((0, 0), (1, 0), (0, 1))), TypeError, "pickled"),
        (lambda: virote.bezier({0: 1}), TypeError, "keys of a record are texts, found int"),
        (lambda: virote.bezier(MASKED), ValueError, "masked"),
        (lambda: virote.mean(MASKED[:, 0]), ValueError, "masked"),
        (lambda: virote.line((0, 0), (1, 0))(MASKED[:, 0]), ValueError, "masked"),
        (lambda: virote.line((0, 0), (1, 0))([Fraction(1, 2), None]), TypeError, "numbers"),
    ],
)
def test_mistakes_are_told(call, raised: type, told: str) -> None:
    with pytest.raises(raised) as caught:
        call()
    assert told.lower() in str(caught.value).lower()


def test_lists_that_share_their_parts_end():
    shared = [1]
    for _ in range(100):
        shared = [shared, shared]
    with pytest.raises(ValueError, match="deep in one another"):
        virote.flatten(shared)


NESTED = """
import threading, virote

def told(call):
    try:
        call()
    except ValueError as err:
        assert "nested in itself, or more than 1000 lists deep" in str(err), err
    else:
        raise AssertionError("it is taken")

def nested(deep):
    found = [1]
    for _ in range(deep - 1):
        found = [found]
    return found

def work():
    cycle, both, record = [], [], {}
    cycle.append(cycle)
    both += [both, both]
    record["a"] = record
    told(lambda: virote.bezier(cycle))
    told(lambda: virote.mean([record]))
    told(lambda: virote.flatten(both))
    told(lambda: virote.flatten(nested(5000)))
    told(lambda: virote.flatten(nested(1001)))
    assert virote.flatten(nested(1000), depth=999).tolist() == [1]

work()
threading.stack_size(4 << 20)
thread = threading.Thread(target=work)
thread.start()
thread.join()
print("well")
"""


def test_what_is_nested_without_end_is_told() -> None:
    # In a process of its own, which would be gone.
    done = subprocess.run([sys.executable, "-c", NESTED], capture_output=True, text=True)
    assert done.stdout == "well\n", done.stderr


def test_values_never_change_and_are_their_own_copies() -> None:
    line = virote.line((0, 0), (1, 0))
    assert copy.copy(line) is line
    assert copy.deepcopy({"c": [line]})["c"][0] is line


def test_numbers_of_other_classes_are_parameters() -> None:
    line = virote.line((0, 0), (4, 0))
    assert line(Fraction(1, 4)).tolist() == [1, 0, 0] and line(Decimal("0.5")).tolist() == [2, 0, 0]
    assert line([Fraction(1, 4), Decimal("0.5"), 1])[:, 0].tolist() == [1, 2, 4]
    unmasked = np.ma.masked_array([0.0, 1.0], mask=[False, False])
    assert line(unmasked)[:, 0].tolist() == [0, 4] and virote.mean(unmasked) == 0.5


def test_operations_have_documentation_and_a_signature() -> None:
    import json

    from virote import _operations, _virote

    for op in json.loads(_virote.operations()):
        name = op["name"]
        function = getattr(virote, name)
        if name in _operations.SHADOWS:
            assert name not in virote.__all__
        else:
            assert name in virote.__all__
        assert op["docs"].split("\n")[0].strip() in function.__doc__
        assert op["signature"].split("(")[0] in function.__doc__
        inspect.signature(function)
    parameters = inspect.signature(virote.circle).parameters
    assert list(parameters) == ["center", "radius", "normal", "form"]


def test_a_region_has_a_border_and_holes() -> None:
    ring = virote.region(virote.circle((0, 0), 2), holes=[virote.circle((0, 0), 1)])
    assert isinstance(ring, virote.Region)
    assert np.allclose(np.linalg.norm(ring.outer([0.1, 0.4]), axis=1), 2)
    assert len(ring.holes) == 1
    assert virote.area(ring) == pytest.approx(3 * np.pi)


def test_warnings_are_warnings() -> None:
    with pytest.warns(virote.GeoWarning, match="W"):
        virote.Session().run_text("")
        virote.closest(virote.circle((0, 0), 1), (0, 0))


def test_a_million_parameters_are_one_call() -> None:
    c = virote.interpolate([(0, 0), (1, 2), (3, 1), (4, 4), (6, 0)])
    t = np.linspace(0, 1, 1_000_000)
    points = c(t)
    assert points.shape == (1_000_000, 3) and points.flags.c_contiguous
    # The same bits, in whatever company a parameter is.
    at = np.arange(0, 1_000_000, 9973)
    assert (c(t[at]) == points[at]).all() and all((c(t[i]) == points[i]).all() for i in at[:20])
    s = virote.bspline([[(i, j, i * j % 3) for j in range(5)] for i in range(6)], degree=3)
    u = np.linspace(0, 1, 2000)
    assert (s(u, u[::-1])[at % 2000] == s(u[at % 2000], u[::-1][at % 2000])).all()


def test_lists_of_numbers_and_points_are_arrays_also_without_any() -> None:
    line = virote.line((0, 0), (1, 0))
    assert virote.inflections(line).shape == (0,) and virote.linspace(0, 1, 3).shape == (3,)
    assert virote.sample(line, 3).shape == (3, 3)


def test_what_is_kept_cannot_be_written_to() -> None:
    c, s = virote.circle((0, 0), 2), virote.sphere((0, 0), 2)
    mesh = s.tessellate(tolerance=0.1)
    table = virote.table({"x": [1, 2], "who": ["a", "b"]})
    results = virote.Session().run_text("let p = (1, 2)  let many = [[1, 2], (3, 4)]  let r = {at: [(1, 2), (3, 4)]}")
    arrays = [
        c.control_points, c.knots, c.weights, s.control_points, s.weights, *s.knots,
        mesh.points, mesh.triangles, mesh.normals, mesh.uv, mesh.cells[0][1],
        table["x"], table.to_dict()["x"], virote.frame_of((0, 0), (1, 0), (0, 1)).origin,
        results["p"], results["many"][0], results["many"][1], results["r"]["at"],
    ]  # fmt: skip
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 99
        array.copy()[0] = 99
    table["who"].append("c")
    assert table["who"] == ["a", "b"] and len(table) == 2
    # They go in again, and what is evaluated is not kept.
    assert virote.polyline(c.control_points).control_points.tolist() == c.control_points.tolist()
    c(np.array([0.5, 1]))[0] = 99
    c.derivatives(0.5)[0] = 99


def test_splines_of_scipy_are_copies() -> None:
    pytest.importorskip("scipy")
    c = virote.bezier([(0, 0), (1, 2), (2, 0)])
    spline = c.to_scipy()
    spline.c[0] = 99
    spline.t[0] = -1
    assert c(0).tolist() == c.control_points[0].tolist() == [0, 0, 0] and c.knots[0] == 0
    assert spline.derivative()(0.5).shape == (3,)
    s = virote.bilinear((0, 0), (0, 1), (1, 0), (1, 1))
    flat = s.to_scipy()
    flat.c[0] = 99
    assert s(0, 0).tolist() == [0, 0, 0]


def test_curves_and_surfaces_are_equal_by_their_numbers() -> None:
    make = lambda x: virote.bezier([(0, 0), (1, x), (2, 0)])
    assert make(2) == make(2) and make(2) != make(3) and hash(make(2)) == hash(make(2))
    assert len({make(2), make(2), make(3)}) == 2
    assert make(0.0) == make(-0.0) and hash(make(0.0)) == hash(make(-0.0)), "zero has no sign"
    assert virote.sphere((0, 0), 2) == virote.sphere((0, 0), 2) != virote.sphere((0, 0), 3)
    assert make(2) != 3 and make(2) != virote.sphere((0, 0), 2) and make(2) is not None
    square = virote.polyline([(0, 0), (1, 0), (1, 1), (0, 0)])
    assert virote.region(square).outer == virote.region(square).outer
    # Of functions nobody can tell.
    f = virote.parametric("t => (t, t^2)", (0, 1))
    assert f == f and f != virote.parametric("t => (t, t^2)", (0, 1)) and len({f, f}) == 1


def test_splines_are_pickled_to_the_last_bit() -> None:
    third = 1 / 3
    for spline in (
        virote.circle((third, 2), 0.1),
        virote.interpolate([(0, third), (1, 2), (3, 1), (4, 4)]),
        virote.sphere((third, 0), 0.7),
        virote.skin([virote.circle((0, 0, z), 1 + z * third) for z in range(3)]),
        virote.trim(virote.circle((0, 0), 1), virote.Range(0.123, 0.777)),
        virote.to_nurbs(virote.parametric("t => (t, sin(t))", (0, 1)), 0.001),
    ):
        again = pickle.loads(pickle.dumps(spline))
        assert type(again) is type(spline) and again == spline and hash(again) == hash(spline)
        for own, other in [(spline.control_points, again.control_points), (spline.weights, again.weights)]:
            assert own.tobytes() == other.tobytes()
        domains = spline.domain if isinstance(spline, virote.Surface) else (spline.domain,)
        place = [low + 0.37 * (high - low) for low, high in domains]
        assert spline(*place).tobytes() == again(*place).tobytes()
    with pytest.raises(Exception, match="knot"):
        from virote import _virote

        _virote.spline([2], [[0, 1]], [0, 0, 0, 1])


def test_methods_are_the_operations() -> None:
    c = virote.circle((0, 0), 2)
    assert c.length() == virote.length(c) and c.length((0, 0.25)) == virote.length(c, range=(0, 0.25))
    t = np.linspace(0, 1, 7)
    assert np.allclose(c.curvature(t), 0.5) and c.curvature(t.reshape(7, 1)).shape == (7, 1)
    assert c.curvature(0.3) == pytest.approx(virote.curvature(c, 0.3))
    assert c.tangent(0.3) == pytest.approx(virote.tangent(c, 0.3)) and c.tangent(t).shape == (7, 3)
    first, second = c.split(0.25)
    assert np.allclose(first(first.domain[1]), second(second.domain[0]))
    assert c.reversed() == virote.reversed(c) and c.is_closed()
    assert c.trim(0.1, 0.4) == virote.trim(c, virote.Range(0.1, 0.4))
    assert c.elevate(4).degree == 4 and len(c.insert_knot(0.1).knots) == len(c.knots) + 1
    assert c.parameter_at_length(c.length()) == pytest.approx(1)
    assert c.closest((4, 0))["point"].tolist() == [2, 0, 0]
    assert c.bounds()["max"].tolist() == pytest.approx([2, 2, 0])
    stands_still = virote.bezier([(0, 0), (0, 0), (1, 1), (2, 0)])
    assert np.isnan(stands_still.curvature(0)) and np.isnan(stands_still.tangent(0)).all()
    s = virote.sphere((0, 0), 2)
    assert s.area() == pytest.approx(16 * np.pi) and s.closest((5, 0))["point"] == pytest.approx([2, 0, 0])
    assert len(s.split(u=0.5)) == 2 and s.swap_uv().degree == s.degree[::-1]
    patch = virote.bilinear((0, 0), (0, 1), (1, 0), (1, 1))
    assert patch.trim(u=(0, 0.5)) == virote.trim(patch, u=virote.Range(0, 0.5))
    assert patch.edge("u0") == virote.edge(patch, "u0") and patch.elevate(u=3).degree == (3, 1)
    assert patch.insert_knot(v=0.5).control_points.shape == (2, 3, 3)
