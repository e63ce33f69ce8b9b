unit m
surface near = bilinear((0, 0), (0, 1), (1, 0), (1, 1))
surface far = translate(near, (500000.3, 5400000.7))
export near to "near.stl"
export far to "far.stl"
export far to "far.gltf"
export far to "exact.stl" with (binary = false)
