// Surfaces through sections, and what is done so that these fit together.
// Columns of control points with other ratios of their distances: every section is met.
fn section(y, z) = bspline([(0, y[0], z), (1, y[1], z), (2, y[2], z), (3, y[3], z), (4, y[4], z)], degree = 3, knots = [0, 0, 0, 0, 0.5, 1, 1, 1, 1])
let sections = [section([0, 0, 0, 0, 0], 0), section([0, 0, 5, 0, 0], 1), section([0, 0, 0, 0, 0], 2), section([0, 0, 0, 8, 0], 3), section([0, 0, 0, 0, 0], 4), section([0, 0, 0, 0, 0], 5)]
surface bumps = skin(sections)
let stands = report(bumps).parameters
check every([for k in 0..5: every([for u in linspace(0, 1, 9): norm(bumps(u, stands[k]) - sections[k](u)) < 1e-14])])

// A common factor of a section's weights changes nothing.
fn heavy(z, f) = nurbs(circle((0, 0, z), 1).points, weights = [for w in circle((0, 0, z), 1).weights: f * w], degree = 2, knots = circle((0, 0, z), 1).knots)
surface pipe = skin([for z in 0..5: heavy(z, if z == 3 then 5 else 1)])
check every([for v in linspace(0, 1, 21): every([for u in linspace(0, 1, 9): abs(hypot(pipe(u, v).x, pipe(u, v).y) - 1) < 1e-14 and abs(pipe(u, v).z - 5*v) < 1e-13])])

// Seams and directions.
surface turned = skin([circle((0, 0, 0), 1), rotate(circle((0, 0, 1), 1), 90deg), rotate(circle((0, 0, 2), 1), 180deg), reversed(circle((0, 0, 3), 1)), rotate(circle((0, 0, 4), 1), -90deg)])
print report(turned)
check every([for v in linspace(0, 1, 21): norm(turned(0, v) - (1, 0, 4*v)) < 1e-13])
check skin([line((0, 0), (1, 0)), line((1, 0, 1), (0, 0, 1))])(0.25, 1) ~= (0.25, 0, 1) within 1e-15
check skin([line((0, 0), (1, 0)), line((1, 0, 1), (0, 0, 1))], align = false)(0.25, 1) ~= (0.75, 0, 1) within 1e-15

// Nothing swings out: radii stay between those of the sections.
let radii = [1, 1.05, 4, 4.2, 1, 0.9]
surface vase = skin([for z in 0..5: circle((0, 0, z), radii[z])], shape = "monotone")
check every([for v in linspace(0, 1, 101): hypot(vase(0.1, v).x, vase(0.1, v).y) >= 0.9 - 1e-14 and hypot(vase(0.1, v).x, vase(0.1, v).y) <= 4.2 + 1e-14])

// A nose and a tail of one point; a ring that closes with the second derivative.
surface drop = skin([(0, 0, 0), circle((0, 0, 1), 1), circle((0, 0, 2), 1.3), (0, 0, 3)])
print drop(0.2, 0), drop(0.7, 1), drop.degree_v
surface ring = skin([for i in 0..5: rotate(circle((4, 0, 0), 1, normal = (0, 1, 0)), 60deg*i)], closed = true)
check derivative(ring, 0.1, 0, du = 0, dv = 2) ~= derivative(ring, 0.1, 1, du = 0, dv = 2) within 1e-10
print ring.degree_v, continuity(ring(0.1, _)).c

// Tangents at the ends.
surface hood = skin([line((0, 0, 0), (1, 0, 0)), line((0, 2, 1), (1, 2, 1))], start_tangent = (0, 0, 3), end_tangent = line((0, 0, -3), (0, 1, -3)))
print hood.degree_v, derivative(hood, 0.5, 0, du = 0, dv = 1), derivative(hood, 0.5, 1, du = 0, dv = 1)
surface bell = skin([circle((0, 0, 0), 1), circle((0, 0, 2), 2), circle((0, 0, 3), 1)], start_tangent = (0, 0, 3))
check derivative(bell, 0.3, 0, du = 0, dv = 1) ~= (0, 0, 3) within 1e-14

// A spine along rational sections.
surface bent = skin([for a in 0..2: rotate(circle((3, 0, 0), 1, normal = (0, 1, 0)), 45deg*a, axis = (0, 0, 1))], spine = arc((0, 0, 0), 3, 0deg, 90deg), at = [0, 0.5, 1])
check norm(cross(unit_vector(derivative(bent, 0.3, 0.5, du = 0, dv = 1)), tangent(arc((0, 0, 0), 3, 0deg, 90deg), 0.5))) < 1e-14

// The NURBS Book, (10.14): a weight below zero is told.
surface swing = skin([
  bezier((0, 0, 0), (1, 0, 2), (3, 0, 0), weights = [1, 2, 1]),
  bezier((0, 1, 1), (1, 2, 3), (3, 1, 0), weights = [1, 1/2, 1]),
  bezier((0, 4, 0), (2, 4, 2), (4, 4, 1), weights = [1, 1, 1]),
], degree = 2)
check swing.weights ~= [[1, 1, 1], [2, -1.0448347473767247, 1], [1, 1, 1]] within 1e-13

// An arc paired with a line by length: straight rulings between equal parts.
curve flat = line((0, 0, 2), (pi/2, 0, 2))
curve bow = arc((0, 0, 0), 1, 0deg, 90deg)
surface paired = skin([bow, flat], pairing = "length", align = false)
check every([for u in linspace(0, 1, 9): norm(paired(u, 0) - (cos(90deg*u), sin(90deg*u), 0)) < 1e-5])
check norm(skin([bow, flat], align = false)(0.25, 0) - (cos(22.5deg), sin(22.5deg), 0)) > 0.01

// With a tolerance, knots that no section needs are gone.
fn dense(z) = interpolate([for i in 0..40: (i/40, sin(90deg*i/40)*(1 + z), z)])
surface thin = skin([dense(0), dense(1), dense(2)], tolerance = 1e-4)
check 2*len(thin.points) < len(skin([dense(0), dense(1), dense(2)]).points)
check every([for u in linspace(0, 1, 41): norm(thin(u, 1) - dense(2)(u)) <= 1e-4])
