geo 1
unit m

// A ball that floats: its cap under water by h holds pi*h^2*(r - h/3).
solid ball = solid(sphere((0, 0), 2))
let water = plane((0, 0, -0.5), (0, 0, 1))
solid immersed = cut(ball, water)
check volume(immersed) ~= pi*1.5^2*(2 - 0.5) within 1e-6
check volume(immersed) + volume(cut(ball, water, keep = "above")) ~= volume(ball) within 1e-6
region waterplane = section(ball, water)[0]
check area(waterplane) ~= pi*(4 - 0.25) within 1e-6
print immersed, waterplane

// Walls: a ring of a plane, and two bodies in one solid.
region ring = region(circle((3, 0), 1), holes = [circle((3, 0), 0.5)])
solid pipe = revolve(ring, axis = (0, 1, 0))
solid half = cut(pipe, plane((0, 0, 0), (0, 1, 0)))
check volume(half) ~= volume(pipe)/2 within 1e-6
solid legs = cut(pipe, plane((0, 0, 0), (1, 0, 0)))
check volume(legs) ~= volume(pipe)/2 within 1e-6
let across = section(pipe, plane((0, 0, 0), (1, 0, 0)))
check len(across) == 2 and area(across[0]) ~= 0.75*pi within 1e-6
check [for r in across: len(r.holes)] == [1, 1]
print half, legs

// At a step: what lies in the plane ends the part below and is no wall of the part above.
solid step = extrude(region(polyline([(0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)], closed = true)), (0, 0, 2))
let tread = plane((0, 1, 0), (0, 1, 0))
check volume(cut(step, tread)) ~= 6 and volume(cut(step, tread, keep = "above")) ~= 6
check [for r in section(step, tread): area(r)] ~= [6]
check cut(step, plane((0, 9, 0), (0, 1, 0)), keep = "above") == none
check volume(cut(step, plane((0, 9, 0), (0, 1, 0)))) ~= 12
check section(step, plane((0, 9, 0), (0, 1, 0))) == []

// Parts are solids like others: they are cut again, move, and have closed meshes.
solid wedge = cut(cut(step, plane((0, 0, 0.5), (0, 0, 1))), plane((0.5, 0, 0), (1, 1, 0)), keep = "above")
print wedge
fn shape(s) = check_mesh(tessellate(s, tolerance = 0.01))
let shapes = [for s in [immersed, half, legs, wedge]: shape(s)]
check every([for c in shapes: c.closed and c.manifold and c.oriented])
