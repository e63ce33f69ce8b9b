unit mm
// A plane that touches a rim in one point, or passes as near to that as the tolerance is wide, cuts there as well.
solid can = solid(cylinder((0, 0), 1, 4), cap = true)
fn across(d) = plane((1 + d, 0, 4), (1, 0, -0.5))
let beside = [0, -1e-9, 1e-7]
fn sides(d) = [cut(can, across(d), keep = "below"), cut(can, across(d), keep = "above")]
check every(beside, d => every(sides(d), s => abs(volume(s) / 1mm^3 - 2*pi) < 2e-6))
check every(sides(0), s => volume(s) ~= 2*pi within 1e-12)
fn is_whole(m) = { let r = check_mesh(m)  r.closed and r.manifold and r.oriented }
check every(beside, d => every(sides(d), s => is_whole(tessellate(s, tolerance = 0.05))))
check volume(tessellate(sides(0)[0], tolerance = 0.001)) ~= 2*pi within 0.01

// The rim of a half ball, from both sides.
solid dome = cut(solid(sphere((0, 0), 1)), XY, keep = "above")
fn tilted(d) = plane((1 + d, 0, 0), (1, 0, 0.3))
fn parts(d) = [cut(dome, tilted(d), keep = "below"), cut(dome, tilted(d), keep = "above")]
check every(beside, d => abs(sum([for s in parts(d): volume(s) / 1mm^3]) - 2/3*pi) < 2e-6)
check every([0, -1e-9, 1e-7], d => is_whole(tessellate(parts(d)[0], tolerance = 0.05)))
