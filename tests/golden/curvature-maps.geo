// Curvature in colours, with its scale.

let ring = torus((0, 0), 3, 1)
let map = curvature_map(ring, "gaussian")
// K = cos v / (r (R + r cos v)): 1/4 outside, −1/2 inside.
check [map.min, map.max] ~= [-0.5, 0.25]
print map.kind, [for s in map.scale: s.color]
check len(map.mesh.colors) == len(map.mesh.vertices)
check every(zip(map.mesh.vertices, map.values), pair => pair[1] ~= (hypot(pair[0].x, pair[0].y) - 3)/hypot(pair[0].x, pair[0].y) within 1e-9)
let bent = curvature_map(cylinder((0, 0), 2, 1), "k1", range = -1..0)
print bent.min, bent.max, bent.scale[4]
check every(bent.values, k => k ~= -0.5)
check curvature_map(sphere((0, 0), 2), "difference").max ~= 0 within 1e-9
// What is the same all over is one value, and white: its rounding is no shade.
check [for kind in ["gaussian", "mean", "k1"]: [for s in curvature_map(sphere((0, 0), 2), kind).scale: norm(s.color - (1, 1, 1))] == [for i in 1..9: 0]] == [true, true, true]
let saddle = curvature_map(bezier([[(0, 0), (0, 1)], [(1, 0), (1, 1)]]), "mean")
check [saddle.min, saddle.max] == [0, 0]
