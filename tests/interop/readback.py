"""Reads the files of `run` back with programs that are not ours, and compares them with the exact
data of our JSON, evaluated here by de Boor's algorithm: no line of the interpreter takes part."""

import io
import json
import pathlib
import subprocess
import sys
import traceback

import numpy as np
from PIL import Image, ImageFilter

HOME = pathlib.Path(sys.argv[1])
OUT = HOME / "out"
ROWS = []
FAILED = []


def tell(file, reader, what, ok):
    ROWS.append((file, reader, what, "ok" if ok else "FAILS"))
    if not ok:
        FAILED.append((file, reader, what))


def span_at(knots, degree, t):
    n = len(knots) - degree - 1
    return max(i for i in range(degree, n) if knots[i] < knots[i + 1] and knots[i] <= min(t, knots[n]))


def basis(knots, degree, t, span=None, up_to=None):
    """The values of all B-splines at t."""
    values = [0.0] * (len(knots) - 1)
    values[span_at(knots, degree, t) if span is None else span] = 1.0
    up_to = degree if up_to is None else up_to
    for p in range(1, up_to + 1):
        for i in range(len(knots) - p - 1):
            left = (t - knots[i]) / (knots[i + p] - knots[i]) * values[i] if knots[i + p] > knots[i] else 0.0
            right = (
                (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) * values[i + 1]
                if knots[i + p + 1] > knots[i + 1]
                else 0.0
            )
            values[i] = left + right
    return np.array(values[: len(knots) - up_to - 1])


def slopes(knots, degree, t):
    """The derivatives of all B-splines at t."""
    lower = basis(knots, degree, t, span_at(knots, degree, t), degree - 1)
    found = np.zeros(len(knots) - degree - 1)
    for i in range(len(found)):
        for k, sign in [(i, 1), (i + 1, -1)]:
            if knots[k + degree] > knots[k]:
                found[i] += sign * degree * lower[k] / (knots[k + degree] - knots[k])
    return found


def nodes(knots, degree):
    """Places and weights of an integral over all spans, by Gauss and Legendre."""
    at, weights = np.polynomial.legendre.leggauss(24)
    ends = sorted(set(knots[degree : len(knots) - degree]))
    for a, b in zip(ends, ends[1:]):
        yield from zip(0.5 * (a + b) + 0.5 * (b - a) * at, 0.5 * (b - a) * weights)


class Curve:
    def __init__(self, data, name=""):
        self.name = name
        self.degree, self.knots = data["degree"], data["knots"]
        self.net = np.array(data["homogeneous"])
        self.domain = self.knots[self.degree], self.knots[len(self.knots) - self.degree - 1]

    def at(self, s):
        t = self.domain[0] + s * (self.domain[1] - self.domain[0])
        point = basis(self.knots, self.degree, t) @ self.net
        return point[:3] / point[3]

    def length(self):
        total = 0.0
        for t, weight in nodes(self.knots, self.degree):
            point, slope = (f(self.knots, self.degree, t) @ self.net for f in (basis, slopes))
            total += weight * np.linalg.norm(slope[:3] - point[:3] / point[3] * slope[3]) / point[3]
        return total


class Surface:
    def __init__(self, data, name=""):
        self.name = name
        self.degrees = data["degree_u"], data["degree_v"]
        self.knots = data["knots_u"], data["knots_v"]
        self.net = np.array(data["homogeneous"])
        self.domains = [(k[p], k[len(k) - p - 1]) for k, p in zip(self.knots, self.degrees)]

    def at(self, s, r):
        rows = [
            basis(k, p, a + f * (b - a))
            for k, p, (a, b), f in zip(self.knots, self.degrees, self.domains, (s, r))
        ]
        point = np.einsum("i,j,ijk->k", rows[0], rows[1], self.net)
        return point[:3] / point[3]

    def across(self, rows, steps):
        """Su x Sv from the B-splines and their derivatives along both parameters."""
        pairs = [(rows[0], rows[1]), (steps[0], rows[1]), (rows[0], steps[1])]
        point, u, v = (np.einsum("i,j,ijk->k", *pair, self.net) for pair in pairs)
        place = point[:3] / point[3]
        return np.cross(*((d[:3] - place * d[3]) / point[3] for d in (u, v)))

    def normal(self, s, r):
        at = [(k, p, a + f * (b - a)) for k, p, (a, b), f in zip(self.knots, self.degrees, self.domains, (s, r))]
        return self.across([basis(*place) for place in at], [slopes(*place) for place in at])

    def area(self):
        lines = [
            [(basis(k, p, t), slopes(k, p, t), weight) for t, weight in nodes(k, p)]
            for k, p in zip(self.knots, self.degrees)
        ]
        total = 0.0
        for row, step, weight in lines[0]:
            for other, other_step, other_weight in lines[1]:
                normal = self.across([row, other], [step, other_step])
                total += weight * other_weight * np.linalg.norm(normal)
        return total


def exact(name):
    """Our curves and surfaces by kind, in their order."""
    found = {"curve": [], "surface": [], "point": []}

    def walk(name, value):
        if isinstance(value, list):
            for member in value:
                walk(name, member)
        elif isinstance(value, dict):
            kind = value.get("virote")
            if kind == "curve":
                found["curve"].append(Curve(value, name))
            elif kind == "surface":
                found["surface"].append(Surface(value, name))
            elif kind == "point":
                found["point"].append(np.array(value["xyz"]))

    for key, value in json.loads((OUT / name).read_text())["values"].items():
        walk(key, value)
    return found


# What STEP has by an equation; all else are B-splines.
KINDS = {
    "tube": "Cylinder", "ball": "Sphere", "ring": "Torus", "hat": "Cone", "flat": "Plane", "crate": "Plane",
    "half": "Plane", "disk": "Plane", "washer": "Plane", "dome": "Sphere", "zone": "Sphere", "elbow": "Torus",
    "fillet": "Torus", "funnel": "Cone", "bore": "Cylinder", "gutter": "Cylinder", "moved": "Sphere",
    "leg": "Line", "round": "Circle", "part": "Circle", "infinite": "Line",
}

PLACES = [0.0, 0.1, 0.25, 0.3, 0.5, 0.613, 0.77, 0.9, 1.0]


def opencascade(file, kind, ours, unit):
    """Faces and edges as OpenCASCADE reads them, checked and compared at equal parameters."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.IFSelect import IFSelect_RetDone
    from OCP.IGESControl import IGESControl_Reader
    from OCP.Interface import Interface_Static
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_VERTEX
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    # Corners stay within one curve.
    Interface_Static.SetIVal_s("read.iges.bspline.continuity", 0)
    reader = STEPControl_Reader() if file.endswith(".step") else IGESControl_Reader()
    ok = reader.ReadFile(str(OUT / file)) == IFSelect_RetDone
    tell(file, "OpenCASCADE", "is read", ok)
    reader.TransferRoots()
    shape = reader.OneShape()
    valid = BRepCheck_Analyzer(shape).IsValid()
    tell(file, "OpenCASCADE", "BRepCheck passes", valid)

    def parts(kind, avoid=None):
        from OCP.TopAbs import TopAbs_SHAPE

        explorer = TopExp_Explorer(shape, kind, avoid if avoid is not None else TopAbs_SHAPE)
        while explorer.More():
            yield explorer.Current()
            explorer.Next()

    as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face
    as_edge = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge
    as_vertex = getattr(TopoDS, "Vertex_s", None) or TopoDS.Vertex
    worst = 0.0
    if kind == "surface":
        faces = list(parts(TopAbs_FACE))
        for i, face in enumerate(faces):
            if not BRepCheck_Analyzer(face).IsValid():
                print("invalid face", i, file=sys.stderr)
        tell(file, "OpenCASCADE", f"{len(faces)} faces", len(faces) == len(ours["surface"]) + N_PARAMETRIC)
        if file.endswith(".step"):
            compare_faces(file, [as_face(face) for face in faces], ours["surface"], unit)
        for face, mine in zip(faces, ours["surface"]):
            if file.endswith(".step") and KINDS.get(mine.name):
                continue
            theirs = BRep_Tool.Surface_s(as_face(face))
            u0, u1, v0, v1 = theirs.Bounds()
            for s in PLACES:
                for r in PLACES:
                    p = theirs.Value(u0 + s * (u1 - u0), v0 + r * (v1 - v0))
                    worst = max(worst, np.linalg.norm(np.array([p.X(), p.Y(), p.Z()]) - unit * mine.at(s, r)))
    else:
        edges = list(parts(TopAbs_EDGE, TopAbs_FACE))
        tell(file, "OpenCASCADE", f"{len(edges)} edges", len(edges) == len(ours["curve"]) + N_PARAMETRIC)
        if file.endswith(".step"):
            compare_edges(file, [as_edge(edge) for edge in edges], ours["curve"], unit)
        for edge, mine in zip(edges, ours["curve"]):
            if file.endswith(".step") and KINDS.get(mine.name):
                continue
            theirs, a, b = BRep_Tool.Curve_s(as_edge(edge), 0.0, 1.0), None, None
            first, last = theirs.FirstParameter(), theirs.LastParameter()
            for s in PLACES:
                p = theirs.Value(first + s * (last - first))
                worst = max(worst, np.linalg.norm(np.array([p.X(), p.Y(), p.Z()]) - unit * mine.at(s)))
        points = list(parts(TopAbs_VERTEX, TopAbs_EDGE))
        for vertex, mine in zip(points, ours["point"]):
            p = BRep_Tool.Pnt_s(as_vertex(vertex))
            worst = max(worst, np.linalg.norm(np.array([p.X(), p.Y(), p.Z()]) - unit * mine))
        tell(file, "OpenCASCADE", f"{len(points)} points", len(points) == len(ours["point"]))
    tell(file, "OpenCASCADE", f"points{' of B-splines' if file.endswith('.step') else ''} at equal parameters within {worst:.1e} mm", worst < 1e-9)
    if file.endswith(".step"):
        looks(file)


def kind_of(adaptor):
    return str(adaptor.GetType()).split("_")[-1]


def told(kinds):
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in sorted(set(kinds)))


def compare_faces(file, faces, ours, unit):
    """Kinds, points, sides and areas of faces; what has an equation has parameters of its own."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.BRepClass import BRepClass_FaceClassifier
    from OCP.BRepGProp import BRepGProp
    from OCP.GeomLProp import GeomLProp_SLProps
    from OCP.gp import gp_Pnt, gp_Pnt2d
    from OCP.GProp import GProp_GProps
    from OCP.ShapeAnalysis import ShapeAnalysis_Surface
    from OCP.TopAbs import TopAbs_OUT, TopAbs_REVERSED

    kinds, gap, miss, are_inside, are_outward = [], 0.0, 0.0, True, True
    for face, mine in zip(faces, ours):
        kind = kind_of(BRepAdaptor_Surface(face, True))
        kinds.append(kind)
        if kind != KINDS.get(mine.name, "BSplineSurface"):
            tell(file, "OpenCASCADE", f"{mine.name} is a {kind}", False)
        if not KINDS.get(mine.name):
            continue
        properties = GProp_GProps()
        BRepGProp.SurfaceProperties_s(face, properties, 1e-11)
        area = unit**2 * mine.area()
        miss = max(miss, abs(properties.Mass() - area) / area)
        surface = BRep_Tool.Surface_s(face)
        analysis = ShapeAnalysis_Surface(surface)
        turned = -1.0 if face.Orientation() == TopAbs_REVERSED else 1.0
        for s in PLACES:
            for r in PLACES:
                uv = analysis.ValueOfUV(gp_Pnt(*map(float, unit * mine.at(s, r))), 1e-7)
                gap = max(gap, analysis.Gap())
                if not (0.0 < s < 1.0 and 0.0 < r < 1.0):
                    continue
                # The parameters of a face may begin in any turn.
                turns = [gp_Pnt2d(uv.X() + i * 2 * np.pi, uv.Y() + j * 2 * np.pi) for i in (-1, 0, 1) for j in (-1, 0, 1)]
                states = [BRepClass_FaceClassifier(face, place, 1e-7).State() for place in turns]
                are_inside &= any(state != TopAbs_OUT for state in states)
                normal = GeomLProp_SLProps(surface, uv.X(), uv.Y(), 1, 1e-9).Normal()
                side = turned * np.dot(mine.normal(s, r), [normal.X(), normal.Y(), normal.Z()])
                are_outward &= bool(0.0 < side)
    tell(file, "OpenCASCADE", f"kinds: {told(kinds)}", True)
    tell(file, "OpenCASCADE", f"points of those with an equation within {gap:.1e} mm", gap < 1e-9)
    tell(file, "OpenCASCADE", "points of those inside of the faces, normals to the same side", are_inside and are_outward)
    tell(file, "OpenCASCADE", f"areas of those within {miss:.1e} of themselves", miss < 1e-9)


def compare_edges(file, edges, ours, unit):
    """Kinds, points and lengths of edges; what has an equation has a parameter of its own."""
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.BRep import BRep_Tool
    from OCP.GCPnts import GCPnts_AbscissaPoint
    from OCP.GeomAPI import GeomAPI_ProjectPointOnCurve
    from OCP.gp import gp_Pnt

    kinds, gap, miss = [], 0.0, 0.0
    for edge, mine in zip(edges, ours):
        adaptor = BRepAdaptor_Curve(edge)
        kinds.append(kind_of(adaptor))
        if kinds[-1] != KINDS.get(mine.name, "BSplineCurve"):
            tell(file, "OpenCASCADE", f"{mine.name} is a {kinds[-1]}", False)
        if not KINDS.get(mine.name):
            continue
        length = unit * mine.length()
        miss = max(miss, abs(GCPnts_AbscissaPoint.Length_s(adaptor) - length) / length)
        curve = BRep_Tool.Curve_s(edge, 0.0, 1.0)
        for s in PLACES:
            point = unit * mine.at(s)
            gap = max(gap, GeomAPI_ProjectPointOnCurve(gp_Pnt(*map(float, point)), curve).LowerDistance())
        for t, s in [(adaptor.FirstParameter(), 0.0), (adaptor.LastParameter(), 1.0)]:
            end = adaptor.Value(t)
            gap = max(gap, np.linalg.norm(np.array([end.X(), end.Y(), end.Z()]) - unit * mine.at(s)))
    tell(file, "OpenCASCADE", f"kinds: {told(kinds)}", True)
    tell(file, "OpenCASCADE", f"points of those with an equation within {gap:.1e} mm", gap < 1e-9)
    tell(file, "OpenCASCADE", f"lengths of those within {miss:.1e} of themselves", miss < 1e-9)


def looks(file):
    """Names, colours and layers, by the reader of documents."""
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_ExtendedString
    try:
        from OCP.collections import Sequence_TDF_Label as TDF_LabelSequence
    except ImportError:  # OpenCASCADE 7
        from OCP.TDF import TDF_LabelSequence
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    document = TDocStd_Document(TCollection_ExtendedString("x"))
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True), reader.SetColorMode(True), reader.SetLayerMode(True)
    reader.ReadFile(str(OUT / file))
    reader.Transfer(document)
    shapes, colors, layers = TDF_LabelSequence(), TDF_LabelSequence(), TDF_LabelSequence()
    XCAFDoc_DocumentTool.ShapeTool_s(document.Main()).GetFreeShapes(shapes)
    XCAFDoc_DocumentTool.ColorTool_s(document.Main()).GetColors(colors)
    XCAFDoc_DocumentTool.LayerTool_s(document.Main()).GetLayerLabels(layers)
    names = set()
    from OCP.TDataStd import TDataStd_Name

    for i in range(1, shapes.Length() + 1):
        name = TDataStd_Name()
        if shapes.Value(i).FindAttribute(TDataStd_Name.GetID_s(), name):
            names.add(name.Get().ToExtString())
    wanted = {"solids.step": {"patch", "crate", "wave"}, "wires.step": {"leg", "marks", "round"}}[file]
    what = f"{len(names)} names, {colors.Length()} colours, {layers.Length()} layers"
    tell(file, "OpenCASCADE", what, wanted <= names and colors.Length() >= 2 and layers.Length() == 1)


def meshes(ours):
    import meshio
    import trimesh

    low = np.min([m.at(s, r) for m in ours["surface"] for s in PLACES for r in PLACES], axis=0)
    high = np.max([m.at(s, r) for m in ours["surface"] for s in PLACES for r in PLACES], axis=0)
    # The parametric one is not in the exact data.
    high[0] = 73.0
    size = np.linalg.norm(high - low)
    counts = {}
    for file in ["solids.stl", "solids-text.stl", "solids.ply", "solids-text.ply", "solids.obj", "solids.glb", "solids.gltf"]:
        mesh = trimesh.load(OUT / file, force="mesh", process=False)
        box = np.array(mesh.bounds)
        if file.endswith(("glb", "gltf")):
            # Back from metres, y upward.
            box = np.array([[b[0], -b[2], b[1]] for b in box]) * 1000
            box = np.sort(box, axis=0)
        near = max(abs(box[0] - low).max(), abs(box[1] - high).max()) < 0.05 * size
        counts[file] = len(mesh.faces)
        tell(file, "trimesh", f"{len(mesh.faces)} triangles, box", near)
    tell("all meshes", "trimesh", "equal counts", len(set(counts.values())) == 1)
    for file in ["solids.stl", "solids-text.stl", "solids.ply", "solids-text.ply", "solids.obj"]:
        try:
            mesh = meshio.read(OUT / file)
            n = sum(len(cells.data) for cells in mesh.cells if cells.type == "triangle")
            tell(file, "meshio", f"{n} triangles", n == counts[file])
        except (Exception, SystemExit) as error:  # a reader that refuses is a finding
            tell(file, "meshio", f"{type(error).__name__}: {error}", False)
    wires = trimesh.load(OUT / "wires.ply", process=False)
    tell("wires.ply", "trimesh", f"{len(wires.vertices)} vertices", len(wires.vertices) > 100)
    scene = trimesh.load(OUT / "solids.glb")
    names = set(scene.geometry)
    tell("solids.glb", "trimesh", f"{len(names)} names", {"patch", "crate[0]", "wave"} <= names)


def gltf():
    files = [str(OUT / f) for f in ["solids.glb", "solids.gltf", "wires.glb", "wires.gltf"]]
    told = subprocess.run(["node", "validate.js", *files], cwd=HOME / "node", capture_output=True, text=True, check=True)
    for line in told.stdout.splitlines():
        report = json.loads(line)
        what = f"{report['numErrors']} errors, {report['numWarnings']} warnings, {report['numInfos']} infos"
        if report["messages"]:
            print(report["messages"], file=sys.stderr)
        tell(report["file"], "gltf-validator", what, report["numErrors"] == report["numWarnings"] == 0)


def dxf(ours):
    import ezdxf

    for file in ["wires.dxf", "solids.dxf", "round.dxf"]:
        document = ezdxf.readfile(OUT / file)
        auditor = document.audit()
        problems = [str(error.message) for error in auditor.errors + auditor.fixes]
        if problems:
            print(problems[:5], file=sys.stderr)
        tell(file, "ezdxf", f"audit: {len(problems)} problems", not problems)
    document = ezdxf.readfile(OUT / "wires.dxf")
    tell("wires.dxf", "ezdxf", f"unit {document.units} (cm)", document.units == 5)
    for file, least in [("wires", 12), ("round", 6)]:
        document = ezdxf.readfile(OUT / f"{file}.dxf")
        named = {}
        for entity in document.modelspace():
            if entity.dxftype() in ("SPLINE", "LINE", "POLYLINE", "CIRCLE", "ARC", "LWPOLYLINE"):
                named[entity.get_xdata("VIROTE")[0].value if entity.has_xdata("VIROTE") else "?"] = entity
        worst, worst_round, n, n_round = 0.0, 0.0, 0, 0
        for name, data in json.loads((OUT / f"{file}.json").read_text())["values"].items():
            if not isinstance(data, dict) or data.get("virote") != "curve" or name not in named:
                continue
            mine, entity = Curve(data), named[name]
            if entity.dxftype() == "SPLINE":
                spline = entity.construction_tool()
                a, b = spline.knots()[spline.degree], spline.knots()[-spline.degree - 1]
                for s in PLACES:
                    p = spline.point(a + s * (b - a))
                    worst = max(worst, np.linalg.norm(np.array([p.x, p.y, p.z]) - mine.at(s)))
            elif entity.dxftype() in ("CIRCLE", "ARC", "LWPOLYLINE"):
                # Each place of ours on theirs, and each of theirs on ours, both as chains of short chords.
                parts = [entity] if entity.dxftype() != "LWPOLYLINE" else list(entity.virtual_entities())
                theirs = np.array([place for part in parts for place in chords(part)])
                mine = np.array([mine.at(s) for s in np.linspace(0, 1, 2001)])
                gaps = [beside(p, theirs) for p in mine[::50]] + [beside(p, mine) for p in theirs[::7]]
                worst_round = max(worst_round, *gaps)
                n_round += 1
            n += 1
        tell(f"{file}.dxf", "ezdxf", f"{n} named curves, splines within {worst:.1e}", n >= least and worst < 1e-9)
        told = f"{n_round} circles, arcs and paths of both within {worst_round:.1e}"
        tell(f"{file}.dxf", "ezdxf", told, n_round >= least // 6 and worst_round < 4 * CHORD)
    document = ezdxf.readfile(OUT / "wires.dxf")
    layers = {layer.dxf.name for layer in document.layers}
    tell("wires.dxf", "ezdxf", "layers", {"lines", "round", "marks"} <= layers)


# How far chords of a DXF's arcs may lie off them.
CHORD = 1e-5


def chords(entity):
    """Places of a line, an arc or a circle, whose chords are near it."""
    if entity.dxftype() == "LINE":
        return [list(entity.dxf.start), list(entity.dxf.end)]
    return [[p.x, p.y, p.z] for p in entity.flattening(CHORD)]


def beside(point, chain):
    """The distance of a point from a chain of chords."""
    start, along = chain[:-1], np.diff(chain, axis=0)
    length = np.maximum((along * along).sum(axis=1), 1e-300)
    share = np.clip(((point - start) * along).sum(axis=1) / length, 0, 1)
    return np.linalg.norm(start + share[:, None] * along - point, axis=1).min()


def svg(ours):
    from xml.etree import ElementTree

    import cairosvg

    for file in ["wires.svg", "solids.svg"]:
        png = cairosvg.svg2png(url=str(OUT / file), output_width=400)
        tree = ElementTree.parse(OUT / file)
        ids = [element.get("id") for element in tree.iter() if element.get("id")]
        tell(file, "CairoSVG", f"drawn, {len(ids)} groups", len(png) > 1000 and len(ids) == len(set(ids)))
        shares = same_ink(browser(file), cairosvg.svg2png(url=str(OUT / file), background_color="white"))
        tell(file, "Chromium", f"drawn, {min(shares):.1%} of the ink where CairoSVG has it", 0.99 < min(shares))


def browser(file):
    """The picture of a page that holds only the file, by a browser without a window."""
    shot = OUT / f"{file}.png"
    subprocess.run(
        ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         "--window-size=2000,2000", f"--screenshot={shot}", (OUT / file).as_uri()],
        check=True, capture_output=True, timeout=120,
    )
    return shot.read_bytes()


def same_ink(one, other):
    """Which shares of the drawn places of each picture are drawn within two of them in the other."""
    pictures = [Image.open(io.BytesIO(picture)).convert("L") for picture in (one, other)]
    size = [min(sides) for sides in zip(*(picture.size for picture in pictures))]
    pictures = [picture.crop((0, 0, *size)) for picture in pictures]
    ink = [np.array(picture) < 200 for picture in pictures]
    near = [np.array(picture.filter(ImageFilter.MinFilter(5))) < 250 for picture in pictures]
    return [(a & b).sum() / a.sum() for a, b in [(ink[0], near[1]), (ink[1], near[0])]]


def free_form(file, ours, kind):
    """OBJ's exact forms, read by twenty lines of our own for want of a reader that keeps them."""
    vertices, forms, now = [], [], {}
    for line in (OUT / file).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            x = [float(x) for x in rest]
            vertices.append(x + [1.0] * (4 - len(x)))
        elif word == "cstype":
            now = {}
        elif word == "deg":
            now["deg"] = [int(d) for d in rest]
        elif word in ("curv", "surf"):
            skip = 2 if word == "curv" else 4
            now["net"] = np.array([vertices[int(i) - 1] for i in rest[skip:]])
        elif word == "parm":
            now[rest[0]] = [float(k) for k in rest[1:]]
        elif word == "end":
            forms.append(now)
    worst = 0.0
    for form, mine in zip(forms, ours[kind]):
        net = form["net"].copy()
        net[:, :3] *= net[:, 3:]
        if kind == "curve":
            theirs = Curve({"degree": form["deg"][0], "knots": form["u"], "homogeneous": net})
            gaps = [np.linalg.norm(theirs.at(s) - mine.at(s)) for s in PLACES]
        else:
            n_u = len(form["u"]) - form["deg"][0] - 1
            grid = net.reshape(-1, n_u, 4).transpose(1, 0, 2)
            data = {"degree_u": form["deg"][0], "degree_v": form["deg"][1], "knots_u": form["u"], "knots_v": form["v"], "homogeneous": grid}
            theirs = Surface(data)
            gaps = [np.linalg.norm(theirs.at(s, r) - mine.at(s, r)) for s in PLACES for r in PLACES]
        worst = max(worst, *gaps)
    tell(file, "the standard's text", f"{len(forms)} forms within {worst:.1e}", len(forms) == len(ours[kind]) + N_PARAMETRIC and worst < 1e-9)


N_PARAMETRIC = 1
solids, wires = exact("solids.json"), exact("wires.json")
STEPS = [
    (opencascade, "solids.step", "surface", solids, 1.0),
    (opencascade, "solids.igs", "surface", solids, 1.0),
    (opencascade, "wires.step", "curve", wires, 10.0),
    (opencascade, "wires.igs", "curve", wires, 10.0),
    (free_form, "solids-exact.obj", solids, "surface"),
    (free_form, "wires-exact.obj", wires, "curve"),
    (meshes, solids),
    (gltf,),
    (dxf, wires),
    (svg, wires),
]
for step, *arguments in STEPS:
    try:
        step(*arguments)
    except Exception as error:  # a reader that gives up is a finding
        traceback.print_exc()
        tell(str(arguments[0]) if arguments and isinstance(arguments[0], str) else "?", step.__name__, str(error), False)
print("| file | read by | what | |\n| --- | --- | --- | --- |")
for row in ROWS:
    print("| " + " | ".join(row) + " |")
sys.exit(f"{len(FAILED)} of {len(ROWS)} fail" if FAILED else 0)
