// One square of two triangles, a line and a point in the text forms of mesh formats.
unit cm
surface tile = bilinear((0, 0, 1), (0, 2, 1), (3, 0, 1), (3, 2, 1)) with (color = "#ff8000", layer = "floor")
curve leg = line((0, 0), (1, 2, 3)) with (color = "blue")
point peak = (1, 1, 4)
export tile to "tile.stl" with (binary = false)
export tile to "binary.stl"
export tile, leg, peak to "all.ply" with (binary = false)
export tile to "tile.ply" with (binary = false, decimals = 2)
export tile to "binary.ply"
export tile, leg, peak to "all.gltf"
export tile, leg, peak to "all.glb"
export tile, leg, peak to "all.obj" with (decimals = 1)
