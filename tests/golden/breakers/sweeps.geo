// Breakers of sweeps: a pipe's surface keeps its radius, whatever its path does; the figures of other programs are in the comments.

let ring = circle((0, 0, 0), 0.1, normal = (1, 0, 0))
let spoke = line((0, 0, 0), (0, 0, 0.1))
fn places(path, n) = [for k in 0..n: lerp(path.domain.start, path.domain.end, k/n)]
// How far points of a pipe are from the radius.
fn miss(s, path) = max([for u in linspace(0, 1, 7): max([for v in places(path, 400): abs(norm(s(u, v) - path(v)) - 0.1)])])
// The same by distances from the whole path, not from the place of the same parameter.
fn apart(s, path) = max([for u in linspace(0, 1, 5): max([for v in places(path, 60): abs(closest(path, s(u, v)).distance - 0.1)])])

// splipy: 1e-3.
test "a straight line" {
  let path = line((0, 0, 0), (3, 1, 2))
  check miss(sweep(ring, path), path) < 1e-15
}

// OCCT with Frenet frames: 0.099.
test "a line, an arc and a line: the curvature jumps" {
  let path = join([line((-2, 0, 0), (0, 0, 0)), arc((0, 1, 0), 1, -90deg, 0deg), line((1, 1, 0), (1, 3, 0))])
  check miss(sweep(ring, path, tolerance = 1e-7), path) < 1e-7
}

// OCCT with Frenet frames: 0.10, the tube collapses; splipy 0.097; curvo 0.44; OCCT with corrected frames: 2e-7.
test "a plane wave whose curvature changes sign" {
  let path = to_nurbs(parametric(t => (6*t, 1.2*sin(360deg*t), 0), 0..1), tolerance = 1e-9)
  let s = sweep(ring, path, tolerance = 1e-7)
  check miss(s, path) < 1e-7
  check apart(s, path) < 1e-7
  // In a plane the frame does not turn.
  check every([for v in places(path, 50): norm(sweep(spoke, path, tolerance = 1e-9)(1, v) - path(v) - (0, 0, 0.1)) < 1e-9])
}

// OCCT with corrected frames: 1.8e-7.
test "a closed curve in space ends as it began" {
  let path = interpolate([for i in 0..71: (cos(5deg*i), sin(5deg*i), 0.5*sin(10deg*i))], closed = true)
  let s = sweep(ring, path, tolerance = 1e-7)
  check miss(s, path) < 1e-7
  check every([for u in linspace(0, 1, 9): norm(s(u, path.domain.start) - s(u, path.domain.end)) < 1e-14])
  // A knot misses itself by an angle that is spread over its length.
  let knot = interpolate([for k in 0..47: ((3 + cos(22.5deg*k))*cos(15deg*k), (3 + cos(22.5deg*k))*sin(15deg*k), sin(22.5deg*k))], closed = true)
  let tube = sweep(ring, knot, tolerance = 1e-7)
  check miss(tube, knot) < 1e-7
  check abs(report(tube).closing_angle) > 1deg
  check every([for u in linspace(0, 1, 9): norm(tube(u, knot.domain.start) - tube(u, knot.domain.end)) < 1e-13])
}

// OCCT with corrected frames: 2e-14, on 6 x 324 control points.
test "a helix: the frame turns by minus the integral of the torsion" {
  let path = to_nurbs(parametric(t => (cos(720deg*t), sin(720deg*t), t), 0..1), tolerance = 1e-12)
  check miss(sweep(ring, path, tolerance = 1e-8), path) < 1e-8
  let s = sweep(spoke, path, tolerance = 1e-10)
  let pitch = 0.5/tau
  let turn = -2*tau*pitch/sqrt(1 + pitch*pitch)*1rad
  let first = (s(1, 0) - path(0))/0.1
  let last = (s(1, 1) - path(1))/0.1
  check dot(last, normal(path, 1)) ~= dot(first, normal(path, 0))*cos(turn) - dot(first, binormal(path, 0))*sin(turn) within 1e-9
  check dot(last, binormal(path, 1)) ~= dot(first, normal(path, 0))*sin(turn) + dot(first, binormal(path, 0))*cos(turn) within 1e-9
}

test "a rational path and a rational section keep the radius" {
  let path = arc((0, 0, 0), 2, 0deg, 270deg)
  check miss(sweep(ring, path), path) < 1e-14
}

test "a path with a cusp is told" {
  expect error "E0607" sweep(ring, bezier((0, 0), (1, 1), (0, 1), (1, 0)))
}

test "a path with corners takes a mitre or is told" {
  let path = polyline((0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1))
  expect error "E0607" sweep(ring, path)
  let s = sweep(ring, path, corner = "miter")
  check every([for u in linspace(0, 1, 9): every([for t in [0.2, 0.5, 0.8]: closest(path, s(u, lerp(path.domain.start, path.domain.end, t/3))).distance ~= 0.1 within 1e-12])])
}

test "a path of no length is told" {
  expect error "E0607" sweep(ring, line((1, 1), (1, 1)))
}
