// Figures whose parts differ in size by many powers of ten, and what touches them, wherever they stand.
geo 1

// Shrunk by more than it is large, nothing is left of a region; grown by a thousand million times that, a disc is one.
region disc = region(circle((0, 0), 1))
check offset(disc, -2) == [] and offset(disc, -1e12) == [] and offset(disc, -1e160) == []
check area(offset(disc, 1e9)[0]) / (pi * 1mm^2) ~= (1e9 + 1)^2 within 1e5

// A step in the border half a tolerance high, and an offset of little more: the corner behind it is rounded.
let h = 5e-7
let d = 6e-7
region step = region(polyline([(0, 0), (1, 0), (1, 1), (0.5, 1), (0.5, 1 + h), (0, 1 + h)], closed = true))
let s = d - h
let beside = d^2 * (pi/4 - asin(s/d)/2rad) - s * sqrt(d^2 - s^2)/2
check area(offset(step, -d)[0]) / 1mm^2 ~= (1 - 2*d)^2 + h*(0.5 - d) - beside within 1e-15

// A window of a hundredth of a millionth of the ball, and its area.
faces parts = split(sphere((0, 0), 1e3), by = sphere((1e3, 0, 0), 1e-3))
check area(parts[1]) / (pi * 1e-6mm^2) ~= 1 within 1e-4
check len(split(sphere((0, 0), 1e3), by = sphere((1e3, 0, 0), 1e-5))) == 2

// Along the circle in which a ring stands on a plate both touch, whichever way they are turned.
fn turned(g, k) = translate(rotate(g, k * 37deg, axis = (1, k, 2 - k)), (k, -2*k, 3))
fn footprint(k) = split(turned(plane_patch((-4, -4), (8, 0), (0, 8)), k), by = turned(torus((0, 0, 1), 2, 1), k))
check every(0..12, k => min([for f in footprint(k): area(f)]) / 1mm^2 ~= 4*pi within 1e-12)

// Cuts across the axis of what turns about one are exact, and so are balls through tubes.
fn cap(k) = trim(turned(sphere((0, 0), 2), k), by = turned(plane((0, 0, 1), (0, 0, 1)), k), keep = "above")
check every(0..6, k => area(cap(k)) / 1mm^2 ~= 4*pi within 1e-13)
fn belt(k) = max([for f in split(turned(sphere((0, 0), 2), k), by = turned(cylinder((0, 0, -3), 1, 6), k)): area(f)])
check every(0..6, k => belt(k) / 1mm^2 ~= 8*pi*sqrt(3) within 1e-12)

// A cap has the triangles of a grid where nothing is cut, and closes with its lid.
face dome = trim(sphere((0, 0), 10), by = plane((0, 0, -3), (0, 0, 1)), keep = "above")
let m = tessellate(solid(dome, cap = true), tolerance = 0.01)
check check_mesh(m).closed and check_mesh(m).manifold and check_mesh(m).oriented
check volume(m) / 1mm^3 ~= pi*13^2*(30 - 13)/3 within 6
