// Nearest points on surfaces that other programs miss, by name.

// Where the gaps to many places of a surface have their least value.
fn sampled(s, p, n) = min([for u in linspace(s.domain_u.start, s.domain_u.end, n), v in linspace(s.domain_v.start, s.domain_v.end, n): norm(s(u, v) - p)])

// OCCT: 166 of 172 wrong where the answer is on the boundary; curvo 61 of 1000, truck 306, verb 11 of 60.
test "a wave of 12 by 12, from above, from below and from beside" {
  let wave = clamped([for i in 0..11: [for j in 0..11: (i, j, sin(1.1rad*i)*cos(0.9rad*j))]])
  let away = [(5, 5, 2), (5.3, 4.4, -1), (-3, 5, 0), (14, -2, 1), (6, 14, -2), (0, 0, 5), (3.1, 7.7, 0.2)]
  check every(away, p => closest(wave, p).distance <= sampled(wave, p, 60))
  check every(away, p => norm(wave(closest(wave, p).u, closest(wave, p).v) - p) ~= closest(wave, p).distance within 1e-12)
}

test "the centre of a sphere and the axis of a torus have endlessly many feet" {
  check closest(sphere((1, 2, 3), 5), (1, 2, 3)).distance ~= 5 within 1e-12
  check closest(torus((0, 0), 3, 1), (0, 0)).distance ~= 2 within 1e-12
  check closest(torus((0, 0), 3, 1), (0, 0, 4)).distance ~= 4 within 1e-12
}

test "a foot on the seam, at a pole and on the edge of a crease" {
  let ball = sphere((0, 0), 2)
  check closest(ball, (5, 0, 0)).point ~= (2, 0, 0) within 1e-12
  check closest(ball, (5, 1e-9, 0)).point ~= (2, 0, 0) within 1e-8
  check closest(ball, (0, 0, 9)).point ~= (0, 0, 2) within 1e-12
  let roof = extrude(polyline([(0, 0), (1, 1), (2, 0)]), (0, 0, 3))
  check closest(roof, (1, 4, 1)).point ~= (1, 1, 1) within 1e-12
}

// conway 594: 71% of 54000 solves on the wrong turn.
test "a ribbon of seven turns" {
  let turns = 7
  let ribbon = parametric((u, v) => (v*cos(u*tau), v*sin(u*tau), 0.5*u), 0..turns, 1..2)
  let outward = (u, v) => unit_vector((0.5*sin(u*tau), -0.5*cos(u*tau), v*tau))
  let places = [for u in [0.3, 1.7, 3.25, 4.9, 6.6], v in [1.1, 1.5, 1.9]: [u, v]]
  check every(places, p => closest(ribbon, ribbon(p[0], p[1]) + 0.1*outward(p[0], p[1])).u ~= p[0] within 1e-6)
}

// iTwin 697: a slightly twisted bilinear patch does not converge.
test "a bilinear patch with a slight twist" {
  let patch = bilinear((0, 0), (0, 10), (10, 0), (10, 10, 0.01))
  let foot = patch(0.3, 0.6)
  let normal = unit_vector(cross(derivative(patch, 0.3, 0.6), derivative(patch, 0.3, 0.6, du = 0, dv = 1)))
  check closest(patch, foot + 3*normal).point ~= foot within 1e-9
}

test "from a million away" {
  check closest(sphere((0, 0), 1), (1e6, 1e6, 0)).point ~= (sqrt(0.5), sqrt(0.5), 0) within 1e-9
  check closest(plane_patch((0, 0), (1, 0), (0, 1)), (0.25, 0.75, 1e6)).point ~= (0.25, 0.75, 0) within 1e-9
}
