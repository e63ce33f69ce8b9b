// Sections along paths.
curve ring = circle((0, 0, 0), 0.1, normal = (1, 0, 0))
// How far a pipe's surface is from its radius.
fn miss(s, path) = max([for u in linspace(0, 1, 5): max([for v in linspace(path.domain.start, path.domain.end, 25): abs(norm(s(u, v) - path(v)) - 0.1)])])

curve straight = line((0, 0, 0), (3, 1, 2))
check miss(sweep(ring, straight), straight) < 1e-15
print sweep(ring, straight).degree_v

// A circle about an axis is an exact torus.
surface torus_of_it = sweep(ring, circle((0, 0, 0), 2))
check every([for u in linspace(0, 1, 7): every([for v in linspace(0, 1, 9): abs(hypot(hypot(torus_of_it(u, v).x, torus_of_it(u, v).y) - 2, torus_of_it(u, v).z) - 0.1) < 1e-14])])

// A plane wave, a closed loop in space, a helix.
curve wave = interpolate([for i in 0..24: (i/4, 1.2*sin(15deg*i), 0)])
check miss(sweep(ring, wave), wave) < 1e-6
curve loop = interpolate([for i in 0..23: (cos(15deg*i), sin(15deg*i), 0.5*sin(30deg*i))], closed = true)
surface knot = sweep(ring, loop)
check miss(knot, loop) < 1e-6
check every([for u in linspace(0, 1, 9): norm(knot(u, loop.domain.start) - knot(u, loop.domain.end)) < 1e-14])
curve spring = helix((0, 0, 0), 1, 0.5, 2)
check miss(sweep(ring, spring), spring) < 1e-6

// In a plane the frame does not turn; along a helix it turns by minus the integral of the torsion.
curve up = line((0, 0, 0), (0, 0, 0.1))
check every([for v in linspace(0, 1, 9): norm(sweep(up, wave)(1, v) - wave(v) - (0, 0, 0.1)) < 1e-6])
let pitch = 0.5/tau
let first = sweep(up, spring)(1, 0) - spring(0)
let last = sweep(up, spring)(1, 1) - spring(1)
let turn = -2*tau*pitch/sqrt(1 + pitch*pitch)*1rad
check dot(last, normal(spring, 1))/0.1 ~= dot(first, normal(spring, 0))/0.1*cos(turn) - dot(first, binormal(spring, 0))/0.1*sin(turn) within 1e-4

// The path is an isocurve where the section passes the origin.
surface band = sweep(bezier((0, -0.1, 0), (0, 0, 0), (0, 0.1, 0)), wave)
check every([for v in linspace(0, 1, 9): norm(band(0.5, v) - wave(v)) < 1e-14])

// Sizes, turns, rails and corners.
surface cone_of_it = sweep(ring, line((0, 0, 0), (0, 0, 4)), scale = [1, 3])
check norm(cone_of_it(0.3, 0.5) - (0, 0, 2)) ~= 0.2 within 1e-15
surface vase = sweep(ring, line((0, 0, 0), (0, 0, 4)), scale = v => 1 + v*v)
check norm(vase(0.3, 0.5) - (0, 0, 2)) ~= 0.125 within 1e-6
surface propeller = sweep(line((0, -1, 0), (0, 1, 0)), line((0, 0, 0), (4, 0, 0)), twist = 180deg)
check propeller(1, 0.5) ~= (2, 0, 1) within 1e-6
surface flag = sweep(up, line((0, 0, 0), (4, 0, 0)), rail = line((0, 1, 0), (4, 0, 1)))
check flag(1, 0) ~= (0, 0.1, 0) within 1e-9
check flag(1, 1) ~= (4, 0, 0.1) within 1e-9
surface gutter = sweep(ring, polyline((0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)), corner = "miter")
print gutter.points[0]

// What cannot be promised is told.
surface flipped = sweep(ring, wave, frame = "frenet")
surface folded = sweep(scale(ring, 20), wave)
