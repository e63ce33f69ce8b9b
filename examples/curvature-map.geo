// The curvature of a vase as colours: a dome is red, a saddle is blue, and white is what a sheet of
// paper could lie on.

geo 1
unit mm

/// The outline, turned about the z axis.
curve outline = interpolate(
    (24, 0, 0),
    (42, 0, 30),
    (40, 0, 70),
    (20, 0, 110),
    (16, 0, 135),
    (27, 0, 160),
)
surface vase = revolve(outline)

let map = curvature_map(vase, "gaussian", tolerance = 0.05, range = -1/1000..1/1000)
print map.kind, map.min, map.max, len(map.scale)

// A surface of revolution is neither dome nor saddle where its outline goes over from one way of
// bending to the other.
let turns = inflections(outline)
print turns
check len(turns) == 1
check every(turns, t => gaussian(vase, 0.1, t) ~= 0 within 1e-9) "flat in one direction there"
check gaussian(vase, 0.1, turns[0] - 0.1) > 0                     "a dome below"
check gaussian(vase, 0.1, turns[0] + 0.1) < 0                     "a saddle above"

export map.mesh to "curvature-map.ply"
