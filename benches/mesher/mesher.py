"""The rows of the table of meshes in benches/README.md; see `run`."""

import math
import os
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_NurbsConvert
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus
from OCP.collections import Array1_double, Array1_int, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineSurface
from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS

VIROTE = os.environ["VIROTE"]
TOLERANCE = 1e-3
N_RUNS = 3
N = 50


def wave():
    """The bicubic spline of N x N control points on a wave."""
    net = Array2_gp_Pnt(1, N, 1, N)
    for i in range(N):
        for j in range(N):
            x, y = 10 * i / (N - 1), 10 * j / (N - 1)
            net.SetValue(i + 1, j + 1, gp_Pnt(x, y, math.sin(x) * math.cos(y)))
    knots, times = Array1_double(1, N - 2), Array1_int(1, N - 2)
    for i in range(N - 2):
        knots.SetValue(i + 1, i / (N - 3))
        times.SetValue(i + 1, 4 if i in (0, N - 3) else 1)
    return Geom_BSplineSurface(net, knots, knots, times, times, 3, 3)


WAVE = wave()


def from_sphere(points):
    return np.abs(np.linalg.norm(points, axis=1) - 10)


def from_torus(points):
    across = np.hypot(points[:, 0], points[:, 1]) - 10
    return np.abs(np.hypot(across, points[:, 2]) - 3)


def from_wave(points):
    some = points[:: max(1, len(points) // 8000)]
    return np.array([GeomAPI_ProjectPointOnSurf(gp_Pnt(*p), WAVE).LowerDistance() for p in some])


def nurbs(shape):
    return BRepBuilderAPI_NurbsConvert(shape).Shape()


NET = "[for i in 0..<50: [for j in 0..<50: (10*i/49, 10*j/49, sin(10*i/49)*cos(10*j/49))]]"
CASES = [
    ("sphere of radius 10", lambda: BRepPrimAPI_MakeSphere(10.0).Shape(), "sphere((0, 0, 0), 10)", from_sphere),
    ("the same as NURBS", lambda: nurbs(BRepPrimAPI_MakeSphere(10.0).Shape()), "sphere((0, 0, 0), 10)", from_sphere),
    ("torus of radii 10 and 3", lambda: BRepPrimAPI_MakeTorus(10.0, 3.0).Shape(), "torus((0, 0, 0), 10, 3)", from_torus),
    ("the same as NURBS", lambda: nurbs(BRepPrimAPI_MakeTorus(10.0, 3.0).Shape()), "torus((0, 0, 0), 10, 3)", from_torus),
    ("bicubic spline of 50 x 50", lambda: BRepBuilderAPI_MakeFace(wave(), 1e-7).Face(), f"clamped({NET})", from_wave),
]


def deviation(vertices, triangles, distance):
    """The largest distance at the middles of triangles and of their sides."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return max(distance(p).max() for p in ((a + b + c) / 3, (a + b) / 2, (b + c) / 2, (c + a) / 2))


def theirs(make, distance):
    seconds = math.inf
    for _ in range(N_RUNS):
        shape = make()
        start = time.perf_counter()
        BRepMesh_IncrementalMesh(shape, TOLERANCE, False, 0.5, False)
        seconds = min(seconds, time.perf_counter() - start)
    found, count, faces = 0.0, 0, TopExp_Explorer(shape, TopAbs_FACE)
    while faces.More():
        mesh = BRep_Tool.Triangulation_s(TopoDS.Face(faces.Current()), TopLoc_Location())
        nodes = (mesh.Node(i) for i in range(1, mesh.NbNodes() + 1))
        vertices = np.array([[p.X(), p.Y(), p.Z()] for p in nodes])
        corners = (mesh.Triangle(i) for i in range(1, mesh.NbTriangles() + 1))
        triangles = np.array([[t.Value(1), t.Value(2), t.Value(3)] for t in corners]) - 1
        found = max(found, deviation(vertices, triangles, distance))
        count += len(triangles)
        faces.Next()
    return seconds, count, found


def run(folder, script):
    (folder / "a.geo").write_text(script)
    start = time.perf_counter()
    subprocess.run([VIROTE, "run", "a.geo", "--quiet", "--threads", "1"], cwd=folder, check=True)
    return time.perf_counter() - start


def ours(code, tolerance, distance):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        surface = f"surface s = {code}\n"
        mesh = f"{surface}mesh m = tessellate(s, tolerance = {tolerance!r}, angle = 90deg)\n"
        bare = min(run(folder, surface) for _ in range(N_RUNS))
        seconds = min(run(folder, mesh) for _ in range(N_RUNS)) - bare
        run(folder, f'{mesh}export m to "m.obj"\n')
        lines = [line.split() for line in (folder / "m.obj").read_text().splitlines()]
        vertices = np.array([line[1:4] for line in lines if line[:1] == ["v"]], float)
        corners = ([part.split("/")[0] for part in line[1:]] for line in lines if line[:1] == ["f"])
        triangles = np.array(list(corners), int) - 1
        return seconds, len(triangles), deviation(vertices, triangles, distance)


for name, make, code, distance in CASES:
    their_seconds, their_count, their_deviation = theirs(make, distance)
    seconds, count, found = ours(code, TOLERANCE, distance)
    # Once more with a request that misses by as much as they do.
    request = float(TOLERANCE * their_deviation / found)
    _, equal, again = ours(code, request, distance)
    equal *= again / their_deviation
    print(
        f"| {name} | {1e3 * seconds:.0f} ms, {count}, {found:.2e} | "
        f"{1e3 * their_seconds:.0f} ms, {their_count}, {their_deviation:.2e} | "
        f"{their_seconds / seconds:.1f} | {equal / their_count:.2f} |",
        flush=True,
    )
