// Breakers of skins: what other programs get wrong, by name; their figures are in the comments.

// How far a section is from the isocurve of a skin at v, at 101 places.
fn miss(s, v, section) = max([for f in linspace(0, 1, 101): norm(s(lerp(s.domain_u.start, s.domain_u.end, f), v) - section(lerp(section.domain.start, section.domain.end, f)))])
fn worst(s, sections) = max([for k in 0..len(sections) - 1: miss(s, report(s).parameters[k], sections[k])])
// How far two surfaces are apart at equal parameters.
fn apart(s, r) = max([for f in linspace(0, 1, 13): max([for g in linspace(0, 1, 41): norm(s(f, g) - r(f, g))])])
fn radius(s, u, v) = hypot(s(u, v).x, s(u, v).y)

// verb and curvo give each column its own parameters and miss section 2 by 0.746 (degree 2) and 1.082 (degree 3).
test "S1: columns of different chord ratios" {
  let heights = [[0, 0, 0, 0, 0], [0, 0, 5, 0, 0], [0, 0, 0, 0, 0], [0, 0, 0, 8, 0], [0, 0, 0, 0, 0], [0, 0, 0, 0, 0]]
  let rows = [for z in 0..5: bspline([for x in 0..4: (x, heights[z][x], z)], degree = 3, knots = [0, 0, 0, 0, 0.5, 1, 1, 1, 1])]
  check worst(skin(rows, degree = 2), rows) < 1e-14
  check worst(skin(rows, degree = 3), rows) < 1e-14
}

// Naive homogeneous skinning: least weight -0.74, heights from -2928 to 427.
test "S2: a common factor of a section's weights changes nothing" {
  let plain = [for z in 0..5: circle((0, 0, z), 1)]
  fn heavier(c, by) = nurbs(c.points, weights = [for w in c.weights: w*by], degree = c.degree, knots = c.knots)
  fn with_third(by) = skin([for z in 0..5: if z == 3 then heavier(plain[z], by) else plain[z]])
  check every([for by in [2, 5, 1000]: min(flatten(with_third(by).weights)) > 0])
  check every([for by in [2, 5, 1000]: apart(with_third(by), skin(plain)) < 1e-13])
  check every([for v in linspace(0, 1, 21): abs(radius(with_third(5), 0.3, v) - 1) < 1e-14])
}

// OCCT makes three faces of degree 10 of circles rotated by 90 degrees; CadQuery flips wires.
test "S3: seams and directions" {
  let round = circle((0, 0, 0), 1)
  fn at(z, angle) = translate(rotate(round, angle), (0, 0, z))
  let turned = skin([at(0, 0deg), at(1, 90deg), at(2, 180deg), at(3, 270deg)])
  check every([for u in linspace(0, 1, 9): every([for v in linspace(0, 1, 31): abs(radius(turned, u, v) - 1) < 1e-9])])
  check len(report(turned).moved_seams) == 3
  let against = skin([at(0, 0deg), reversed(at(1, 0deg)), at(2, 0deg), reversed(at(3, 90deg))])
  check every([for u in linspace(0, 1, 9): every([for v in linspace(0, 1, 31): abs(radius(against, u, v) - 1) < 1e-9])])
  check report(against).reversed == [1, 3]
}

// splipy's plain cubic pinches to the radius 0.047 at z = 4.58, where the circles have 1 and 0.9.
test "S4: overshoot" {
  let radii = [1, 1.05, 4, 4.2, 1, 0.9]
  let rings = [for z in 0..5: circle((0, 0, z), radii[z])]
  let s = skin(rings, shape = "monotone")
  check worst(s, rings) < 1e-14
  check min([for v in linspace(0, 1, 401): radius(s, 0, v)]) >= 0.9 - 1e-15
  check max([for v in linspace(0, 1, 401): radius(s, 0, v)]) <= 4.2 + 1e-15
}

// curvo: "Knots to insert are not in order".
test "S5: an arc and a polyline" {
  let sections = [arc((0, 0, 0), 1, 0deg, 90deg), polyline((1, 0, 1), (1, 1, 1), (0, 1, 1))]
  let s = skin(sections)
  check worst(s, sections) < 1e-15
  check every([for u in linspace(0, 1, 11): abs(radius(s, u, 0) - 1) < 1e-15])
}

// curvo keeps a span of a billionth.
test "S6: knots a billionth apart" {
  fn row(z, t) = bspline([for x in 0..4: (x, x*x, z)], degree = 3, knots = [0, 0, 0, 0, t, 1, 1, 1, 1])
  let sections = [row(0, 0.5), row(1, 0.5 + 1e-9), row(2, 0.5)]
  let s = skin(sections)
  check len(s.points) == 5
  check worst(s, sections) < 1e-8
}

test "S7: points at both ends" {
  let sections = [circle((0, 0, 1), 1), circle((0, 0, 2), 1.5), circle((0, 0, 3), 1)]
  let s = skin([(0, 0, 0), ...sections, (0, 0, 4)])
  check every([for u in linspace(0, 1, 9): norm(s(u, 0)) < 1e-15 and norm(s(u, 1) - (0, 0, 4)) < 1e-15])
  check every([for v in linspace(0.01, 0.99, 21): abs(radius(s, 0.1, v) - radius(s, 0.6, v)) < 1e-14])
}

test "S8: two sections at one place" {
  let a = line((0, 0), (1, 0))
  expect error "E0607" skin([a, a, line((0, 1), (1, 1))])
  check skin([a, a, line((0, 1), (1, 1))], parameters = [0, 0.5, 1])(0.5, 0.25).y < 0
}

// Rhino rules an arc and a line between points of equal parameter: lines that are not straight to equal lengths.
test "S9: points of equal length" {
  let bow = bezier((0, 0, 0), (0, 0, 2), (3, 0, 0))
  let s = skin([bow, line((0, 1, 0), (3, 1, 0))], pairing = "length")
  fn half(t) = norm(bow(t) - s(0.5, 0)) 
  let middle = bow(parameter_at_length(bow, length(bow)/2))
  check norm(s(0.5, 0) - middle) < 2e-6
  check s(0.5, 1) ~= (1.5, 1, 0) within 1e-12
}

// Other degrees, knots, directions, starting points, weights: all are isocurves.
test "sections of every kind" {
  let sections = [
    circle((0, 0, 0), 1),
    circle((0, 0, 1), 1.2),
    interpolate([for k in 0..11: (1.4*cos(30deg*k), 1.3*sin(30deg*k), 2 + 0.1*sin(60deg*k))], closed = true),
  ]
  let s = skin(sections)
  check worst(s, sections) < 1e-9
  check s.degree_v == 2
}
