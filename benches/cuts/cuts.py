"""The rows of the table of cuts in benches/README.md; see `run`."""

import math
import os
import random
import re
import resource
import subprocess
import tempfile
import time
from math import pi
from pathlib import Path

import numpy as np
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse, BRepAlgoAPI_Section, BRepAlgoAPI_Splitter
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
from OCP.BRepGProp import BRepGProp
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakeOffset
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus
from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_int, Array2_gp_Pnt, List_TopoDS_Shape
from OCP.Geom import Geom_BezierCurve, Geom_BezierSurface, Geom_BSplineSurface
from OCP.GeomAbs import GeomAbs_Arc
from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pln, gp_Pnt, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.TopAbs import TopAbs_FACE, TopAbs_WIRE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

VIROTE = os.environ["VIROTE"]
N_RUNS = 3
# How often the command does the work in a process.
N_TIMES = 5
# What OpenCASCADE's adaptive integral is asked for.
ACCURACY = 1e-10
ORIGIN, UP, ACROSS = gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)


def integral(f, a, b, n=64):
    """By Gauss and Legendre, with ends at which f goes as a square root taken together there."""
    nodes, weights = np.polynomial.legendre.leggauss(n)
    # x = a + (b - a) (3 s^2 - 2 s^3) is flat at both ends.
    s = 0.5 * (nodes + 1)
    x = a + (b - a) * s * s * (3 - 2 * s)
    return float(np.sum(0.5 * weights * 6 * s * (1 - s) * (b - a) * np.array([f(value) for value in x])))


# --- What OpenCASCADE does.


def listed(shapes):
    found = List_TopoDS_Shape()
    for shape in shapes:
        found.Append(shape)
    return found


def boolean(operation, arguments, tools):
    operation.SetArguments(listed(arguments))
    operation.SetTools(listed(tools))
    operation.SetRunParallel(False)
    operation.Build()
    return operation.Shape()


def parts(shape, kind=TopAbs_FACE):
    found, explorer = [], TopExp_Explorer(shape, kind)
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def area(shape):
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(shape, properties, ACCURACY)
    return properties.Mass()


def volume(shape):
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties, ACCURACY, False, False)
    return properties.Mass()


def length(shape):
    properties = GProp_GProps()
    BRepGProp.LinearProperties_s(shape, properties)
    return properties.Mass()


def least(shape):
    return min(area(face) for face in parts(shape))


def without_largest(shape):
    return all_of(shape) - max(area(face) for face in parts(shape))


def amid(shape):
    """The area of the faces about the middle along z: seams may divide what is one face to others."""
    found = 0.0
    for face in parts(shape):
        properties = GProp_GProps()
        BRepGProp.SurfaceProperties_s(face, properties, ACCURACY)
        found += properties.Mass() if abs(properties.CentreOfMass().Z()) < 0.5 else 0.0
    return found


def all_of(shape):
    return sum(area(face) for face in parts(shape))


def disc(x, y, radius):
    edge = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(x, y, 0), UP), radius)).Edge()
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire(), True).Face()


def plane(x, y, z, normal):
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(x, y, z), normal), -20, 20, -20, 20).Face()


def side(shape):
    """The face of a cylinder between its rims."""
    return max(parts(shape), key=area)


def cylinder(x, y, z, radius, height, axis=UP):
    return side(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), axis), radius, height).Shape())


def sphere(radius):
    return BRepPrimAPI_MakeSphere(radius).Shape()


def torus(major, minor):
    return BRepPrimAPI_MakeTorus(major, minor).Shape()


def outline(corners):
    """Cubic Bézier curves that follow one another."""
    wire = BRepBuilderAPI_MakeWire()
    for points in corners:
        poles = Array1_gp_Pnt(1, len(points))
        for i, (x, y) in enumerate(points):
            poles.SetValue(i + 1, gp_Pnt(x, y, 0))
        wire.Add(BRepBuilderAPI_MakeEdge(Geom_BezierCurve(poles)).Edge())
    return wire.Wire()


def grown(wires, distance):
    face = BRepBuilderAPI_MakeFace(wires[0])
    for wire in wires[1:]:
        face.Add(TopoDS.Wire(wire.Reversed()))
    offset = BRepOffsetAPI_MakeOffset(face.Face(), GeomAbs_Arc)
    offset.Perform(distance)
    found = sorted(parts(offset.Shape(), TopAbs_WIRE), key=lambda w: -area_within(w))
    return area_within(found[0]) - sum(area_within(wire) for wire in found[1:])


def area_within(wire):
    return abs(area(BRepBuilderAPI_MakeFace(TopoDS.Wire(wire), True).Face()))


def bezier(net):
    poles = Array2_gp_Pnt(1, len(net), 1, len(net[0]))
    for i, row in enumerate(net):
        for j, point in enumerate(row):
            poles.SetValue(i + 1, j + 1, gp_Pnt(*point))
    return BRepBuilderAPI_MakeFace(Geom_BezierSurface(poles), 1e-7).Face()


def spline(net):
    n = len(net)
    poles = Array2_gp_Pnt(1, n, 1, n)
    for i, row in enumerate(net):
        for j, point in enumerate(row):
            poles.SetValue(i + 1, j + 1, gp_Pnt(*point))
    knots, times = Array1_double(1, n - 2), Array1_int(1, n - 2)
    for i in range(n - 2):
        knots.SetValue(i + 1, i / (n - 3))
        times.SetValue(i + 1, 4 if i in (0, n - 3) else 1)
    return BRepBuilderAPI_MakeFace(Geom_BSplineSurface(poles, knots, knots, times, times, 3, 3), 1e-7).Face()


# --- The figures, and their closed forms.

RANDOM = random.Random(1)
DISCS = [(RANDOM.uniform(0, 12), RANDOM.uniform(0, 12), RANDOM.uniform(0.5, 1.2)) for _ in range(150)]
HOLES = [(i, j, 0.3) for i in range(1, 11) for j in range(1, 11)]


def area_of_discs():
    """Green's theorem along what of each circle no other disc covers."""
    found = 0.0
    for i, (x, y, r) in enumerate(DISCS):
        covered, is_inside = [], False
        for j, (a, b, s) in enumerate(DISCS):
            away = math.hypot(a - x, b - y)
            if i == j or r + s <= away or s + away <= r:
                continue
            if r + away <= s:
                is_inside = True
                break
            middle = math.atan2(b - y, a - x) % (2 * pi)
            half = math.acos((r * r + away * away - s * s) / (2 * r * away))
            low, high = middle - half, middle + half
            covered += [(low, high), (low + 2 * pi, high + 2 * pi), (low - 2 * pi, high - 2 * pi)]
        if is_inside:
            continue
        end = 0.0
        for low, high in sorted(covered) + [(2 * pi, 2 * pi)]:
            low = min(low, 2 * pi)
            if end < low:
                found += 0.5 * r * (x * (math.sin(low) - math.sin(end)) - y * (math.cos(low) - math.cos(end)) + r * (low - end))
            end = max(end, high)
    return found


def oval(x, y, a, b):
    """A convex outline of four cubics, as of the letter O."""
    k, l = 0.62 * a, 0.62 * b
    return [
        [(x + a, y), (x + a, y + l), (x + k, y + b), (x, y + b)],
        [(x, y + b), (x - k, y + b), (x - a, y + l), (x - a, y)],
        [(x - a, y), (x - a, y - l), (x - k, y - b), (x, y - b)],
        [(x, y - b), (x + k, y - b), (x + a, y - l), (x + a, y)],
    ]


def area_and_length(corners):
    sums = [0.0, 0.0]
    for points in corners:
        p = [np.array(point) for point in points]
        at = lambda t: (1 - t) ** 3 * p[0] + 3 * t * (1 - t) ** 2 * p[1] + 3 * t * t * (1 - t) * p[2] + t**3 * p[3]
        slope = lambda t: 3 * ((1 - t) ** 2 * (p[1] - p[0]) + 2 * t * (1 - t) * (p[2] - p[1]) + t * t * (p[3] - p[2]))
        sums[0] += integral(lambda t: 0.5 * (at(t)[0] * slope(t)[1] - at(t)[1] * slope(t)[0]), 0, 1)
        sums[1] += integral(lambda t: math.hypot(*slope(t)), 0, 1)
    return sums


OUTER, INNER, GROWTH = oval(0, 0, 3, 4), oval(0, 0, 1.9, 3), 0.25
LETTER = sum(
    sign * (found + sign * GROWTH * along + pi * GROWTH**2)
    for sign, (found, along) in [(1, area_and_length(OUTER)), (-1, area_and_length(INNER))]
)

# z = x^3 + y/2 over a square, cut at z = 0.6: below it y < 1.2 - 2x^3.
SLOPE = [[(i / 3, j / 3, (1 if i == 3 else 0) + j / 6) for j in range(4)] for i in range(4)]
BELOW = integral(lambda x: math.sqrt(1.25 + 9 * x**4) * min(1.0, max(0.0, 1.2 - 2 * x**3)), 0, 0.1 ** (1 / 3)) + integral(
    lambda x: math.sqrt(1.25 + 9 * x**4) * (1.2 - 2 * x**3), 0.1 ** (1 / 3), 0.6 ** (1 / 3)
)
N = 50
WAVE = [[(10 * i / (N - 1), 10 * j / (N - 1), math.sin(10 * i / (N - 1)) * math.cos(10 * j / (N - 1))) for j in range(N)] for i in range(N)]
TILT = [[(10 * i / (N - 1), 10 * j / (N - 1), 0.02 * i - 0.5 + 0.1 * math.sin(10 * j / (N - 1))) for j in range(N)] for i in range(N)]


def beyond(x):
    """The area of the torus of radii 3 and 1 beyond a distance from its axis along x."""
    start = math.acos(min(1.0, x - 3)) if 2 < x else pi
    return 2 * integral(lambda v: (3 + math.cos(v)) * 2 * math.acos(min(1.0, x / (3 + math.cos(v)))), 0, start, 400)


def flow(x):
    """The volume of that torus beyond it."""
    cap = lambda r: 0.0 if r <= x else r * r * math.acos(x / r) - x * math.sqrt(r * r - x * x)
    both = lambda z: cap(3 + math.sqrt(1 - z * z)) - cap(3 - math.sqrt(1 - z * z))
    # Where the plane touches the inner circle the rest of it comes in.
    turn = math.sqrt(0.75)
    return 2 * (integral(both, 0, turn, 400) + integral(both, turn, 1, 400))


def cube(points):
    return "[" + ", ".join(f"({x!r}, {y!r})" for x, y in points) + "]"


def loop(corners):
    return "join([" + ", ".join(f"bezier({cube(points)})" for points in corners) + "])"


def net(rows):
    return "[" + ", ".join("[" + ", ".join(f"({x!r}, {y!r}, {z!r})" for x, y, z in row) + "]" for row in rows) + "]"


# Name, closed form, what OpenCASCADE begins with, does and answers; the same of the command.
CASES = [
    (
        "union of 150 random discs",
        area_of_discs(),
        lambda: [disc(*each) for each in DISCS],
        lambda discs: boolean(BRepAlgoAPI_Fuse(), discs[:1], discs[1:]),
        all_of,
        "let discs = [" + ", ".join(f"region(circle(({x!r}, {y!r}), {r!r}))" for x, y, r in DISCS) + "]",
        "union(discs)",
        "sum([for part in made: area(part)])",
    ),
    (
        "100 holes in a plate",
        121 - 9 * pi,
        lambda: (BRepBuilderAPI_MakeFace(gp_Pln(ORIGIN, UP), 0, 11, 0, 11).Face(), [disc(*each) for each in HOLES]),
        lambda given: boolean(BRepAlgoAPI_Cut(), [given[0]], given[1]),
        all_of,
        "let plate = region(polyline([(0, 0), (11, 0), (11, 11), (0, 11)], closed = true))\n"
        "let discs = [for i in 0..99: region(circle((1 + i % 10, 1 + floor(i / 10)), 0.3))]",
        "difference(plate, discs)",
        "area(made[0])",
    ),
    (
        "a letter O of eight cubics, grown by 0.25",
        LETTER,
        lambda: [outline(OUTER), outline(INNER)],
        lambda wires: grown(wires, GROWTH),
        lambda found: found,
        f"let letter = region({loop(OUTER)}, holes = [{loop(INNER)}])",
        f"offset(letter, {GROWTH})",
        "area(made[0])",
    ),
    (
        "sphere divided by a plane",
        4 * pi,
        lambda: (sphere(2.0), plane(0, 0, 1, UP)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), parts(given[0]), [given[1]]),
        least,
        "let ball = sphere((0, 0), 2)\nlet cutter = plane((0, 0, 1), (0, 0, 1))",
        "split(ball, by = cutter)",
        "min([for part in made: area(part)])",
    ),
    (
        "sphere by a cylinder that touches it (Viviani)",
        2 * pi - 4,
        lambda: (sphere(1.0), cylinder(0.5, 0, -2, 0.5, 4)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), parts(given[0]), [given[1]]),
        without_largest,
        "let ball = sphere((0, 0), 1)\nlet cutter = cylinder((0.5, 0, -2), 0.5, 4)",
        "split(ball, by = cutter)",
        "sum([for part in made: area(part)]) - max([for part in made: area(part)])",
    ),
    (
        "sphere by a cylinder about its middle",
        8 * pi * math.sqrt(3),
        lambda: (sphere(2.0), cylinder(0, 0, -3, 1, 6)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), parts(given[0]), [given[1]]),
        lambda shape: max(area(face) for face in parts(shape)),
        "let ball = sphere((0, 0), 2)\nlet cutter = cylinder((0, 0, -3), 1, 6)",
        "split(ball, by = cutter)",
        "max([for part in made: area(part)])",
    ),
    (
        "torus by a plane beside its axis (spiric)",
        beyond(2.5),
        lambda: (torus(3.0, 1.0), plane(2.5, 0, 0, ACROSS)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), parts(given[0]), [given[1]]),
        without_largest,
        "let ring = torus((0, 0), 3, 1)\nlet cutter = plane((2.5, 0, 0), (1, 0, 0))",
        "split(ring, by = cutter)",
        "min([for part in made: area(part)])",
    ),
    (
        "cylinder by a cylinder of the same radius (Steinmetz)",
        8.0,
        lambda: (cylinder(0, 0, -3, 1, 6), cylinder(-3, 0, 0, 1, 6, ACROSS)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), [given[0]], [given[1]]),
        amid,
        "let tube = cylinder((0, 0, -3), 1, 6)\nlet cutter = cylinder((-3, 0, 0), 1, 6, axis = (1, 0, 0))",
        "split(tube, by = cutter)",
        "sum(sort([for part in made: area(part)])[0..1])",
    ),
    (
        "bicubic patch by a plane",
        BELOW,
        lambda: (bezier(SLOPE), plane(0, 0, 0.6, UP)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), [given[0]], [given[1]]),
        lambda shape: max(area(face) for face in parts(shape)),
        f"let patch = bezier({net(SLOPE)})\nlet cutter = plane((0, 0, 0.6), (0, 0, 1))",
        "split(patch, by = cutter)",
        "max([for part in made: area(part)])",
    ),
    (
        "bicubic spline of 50 x 50 by another",
        None,
        lambda: (spline(WAVE), spline(TILT)),
        lambda given: boolean(BRepAlgoAPI_Splitter(), [given[0]], [given[1]]),
        all_of,
        f"let wave = clamped({net(WAVE)})\nlet cutter = clamped({net(TILT)})",
        "split(wave, by = cutter)",
        "sum([for part in made: area(part)])",
    ),
    (
        "torus cut by a plane beside its axis, closed",
        flow(2.5),
        lambda: (torus(3.0, 1.0), BRepPrimAPI_MakeBox(gp_Pnt(2.5, -5, -5), gp_Pnt(5, 5, 5)).Shape()),
        lambda given: boolean(BRepAlgoAPI_Common(), [given[0]], [given[1]]),
        volume,
        "let ring = solid(torus((0, 0), 3, 1))\nlet cutter = plane((2.5, 0, 0), (1, 0, 0))",
        'cut(ring, cutter, keep = "above")',
        "volume(made)",
    ),
    (
        "ball cut by a plane, closed",
        5 / 3 * pi,
        lambda: (sphere(2.0), BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 1), gp_Pnt(5, 5, 5)).Shape()),
        lambda given: boolean(BRepAlgoAPI_Common(), [given[0]], [given[1]]),
        volume,
        "let ball = solid(sphere((0, 0), 2))\nlet cutter = plane((0, 0, 1), (0, 0, 1))",
        'cut(ball, cutter, keep = "above")',
        "volume(made)",
    ),
    (
        "section of a sphere",
        2 * pi * math.sqrt(3),
        lambda: (sphere(2.0), gp_Pln(gp_Pnt(0, 0, 1), UP)),
        lambda given: BRepAlgoAPI_Section(given[0], given[1], True).Shape(),
        length,
        "let ball = sphere((0, 0), 2)\nlet cutter = plane((0, 0, 1), (0, 0, 1))",
        "section(ball, cutter)",
        "sum([for line in made: length(line)])",
    ),
    (
        "section of a torus beside its axis",
        None,
        lambda: (torus(3.0, 1.0), gp_Pln(gp_Pnt(2.5, 0, 0), ACROSS)),
        lambda given: BRepAlgoAPI_Section(given[0], given[1], True).Shape(),
        length,
        "let ring = torus((0, 0), 3, 1)\nlet cutter = plane((2.5, 0, 0), (1, 0, 0))",
        "section(ring, cutter)",
        "sum([for line in made: length(line)])",
    ),
]


def theirs(make, do, measure):
    seconds = math.inf
    for _ in range(N_RUNS):
        given = make()
        start = time.process_time()
        try:
            made = do(given)
        except Exception as error:  # OpenCASCADE's own
            return None, str(error).splitlines()[0][:40]
        seconds = min(seconds, time.process_time() - start)
    return seconds, measure(made)


def run(folder, script):
    (folder / "a.geo").write_text(script)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([VIROTE, "run", "a.geo", "--threads", "1"], cwd=folder, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return seconds, done.stdout


def ours(given, do, measure):
    with tempfile.TemporaryDirectory() as name:
        folder, made = Path(name), f"geo 1\n{given}\nlet made = {do}\n"
        # The work stands there so many times that the start of the process does not matter.
        many = f"geo 1\n{given}\nlet made = [for i in 1..{N_TIMES}: {do}]\n"
        bare = min(run(folder, f"geo 1\n{given}\n")[0] for _ in range(N_RUNS))
        seconds = (min(run(folder, many)[0] for _ in range(N_RUNS)) - bare) / N_TIMES
        _, told = run(folder, f"{made}print {measure}\n")
        return seconds, float(re.search(r"= (-?[0-9.e-]+)", told).group(1))


def main():
    print("| work | here | OpenCASCADE | ratio | off here | off there |\n| --- | --- | --- | --- | --- | --- |")
    for name, form, make, do, measure, given, code, asked in CASES:
        their_seconds, their_value = theirs(make, do, measure)
        seconds, value = ours(given, code, asked)
        off = lambda found: f"{abs(found / form - 1):.0e}" if form and not isinstance(found, str) else "" if form else f"{found!r}"
        ratio = f"{their_seconds / seconds:.1f}" if their_seconds else ""
        their_time = f"{1e3 * their_seconds:.1f} ms" if their_seconds else f"fails: {their_value}"
        print(f"| {name} | {1e3 * seconds:.1f} ms | {their_time} | {ratio} | {off(value)} | {off(their_value)} |", flush=True)


main()
