"""Reads the trimmed faces and solids of `trimmed.geo` with OpenCASCADE: whether they are valid, their areas by curves of
parameters and their volumes, beside our own answers in `trimmed.csv`. Arguments: the folder of the files, and names of
shapes where not all are wanted."""

import csv
import math
import pathlib
import sys

from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.IGESControl import IGESControl_Reader
from OCP.Interface import Interface_Static
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer

OUT = pathlib.Path(sys.argv[1])

# Relative, by the adaptive integral of OpenCASCADE, which is asked for less.
AGREE = 1e-9
ASKED = 1e-12


def members(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def measures(shape):
    """Area of all faces, volume of all solids."""
    area, volume = 0.0, 0.0
    for face in members(shape, TopAbs_FACE):
        found = GProp_GProps()
        BRepGProp.SurfaceProperties_s(face, found, ASKED)
        area += found.Mass()
    for solid in members(shape, TopAbs_SOLID):
        found = GProp_GProps()
        BRepGProp.VolumeProperties_s(solid, found, ASKED, True, True)
        volume += found.Mass()
    return area, volume


def read(path):
    reader = STEPControl_Reader() if path.suffix == ".step" else IGESControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_RetDone:
        return None
    reader.TransferRoots()
    return reader.OneShape()


def off(found, wanted):
    return abs(found - wanted) / abs(wanted)


Interface_Static.SetIVal_s("read.iges.bspline.continuity", 0)
rows = list(csv.DictReader((OUT / "trimmed.csv").open()))
wanted = {row["name"]: [float(v) for k, v in row.items() if k != "name"] for row in rows}
failed = 0
for name in sys.argv[2:] or wanted:
    area, volume = wanted[name]
    for ending in ["step", "igs"]:
        path = OUT / "trimmed" / f"{name}.{ending}"
        shape = read(path)
        valid = shape is not None and BRepCheck_Analyzer(shape).IsValid()
        found = measures(shape) if shape is not None else (math.nan, math.nan)
        areas, volumes = off(found[0], area), 0.0
        if volume and ending == "step":
            volumes = off(found[1], volume)
        ok = valid and areas <= AGREE and volumes <= AGREE
        failed += not ok
        print(f"| {name}.{ending} | {'valid' if valid else 'NOT VALID'} | {areas:.1e} | {volumes:.1e} | {'ok' if ok else 'FAILS'} |", flush=True)
print(f"{failed} of {2 * len(wanted)} fail", file=sys.stderr)
sys.exit(failed != 0)
