surface s = bilinear((0, 0), (0, 1e40), (1e40, 0), (1e40, 1e40))
export s to "a.stl"
export s to "b.glb"
