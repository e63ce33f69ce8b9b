// The ellipse with half axes 2 and 1: the least radius of curvature is b²/a = 1/2, at both ends of
// the long axis; the largest a²/b = 4.
curve oval = ellipse((0, 0), 2, 1)
let touching = report(offset(oval, -0.5))
print touching.cusps
check len(touching.crossings) == 0

// Beyond it there are four cusps, where the radius is the distance, and two swallowtails whose
// crossings lie on the long axis at (a² − b²)/a · sqrt(1 − d²/b²), here 3/2 · sqrt(3)/2 · ... by
// symmetry (x, 0).
let folded = report(offset(oval, -0.75))
check len(folded.cusps) == 4
check every(folded.cusps, t => radius_of_curvature(oval, t) ~= 0.75 within 1e-7)
check len(folded.crossings) == 2
// The normal at the foot (2 cos θ, sin θ) reaches the axis at x = 3/2 cos θ after the length
// sqrt(sin² θ + cos² θ/4): 0.75 for cos² θ = 7/12.
check every(folded.crossings, c => abs(c.point.y) < 1e-6 and abs(abs(c.point.x) - 1.5 * sqrt(7/12)) < 1e-6)

// Beyond every radius all of it runs backwards.
curve inverted = offset(oval, -5)
curve hollow = offset(circle((0, 0), 2), -3)
check hollow(0) ~= (-1, 0)

// A parabola y = x² has the least radius 1/2 at its vertex; one piece and many tell the same.
curve parabola = bezier((-1, 1), (0, -1), (1, 1))
check report(offset(parabola, -0.5)).cusps ~= [0.5] within 1e-4
check len(report(offset(insert_knot(parabola, 0.5), -0.5)).cusps) == 1
let tail = report(offset(parabola, -1))
check len(tail.cusps) == 2 and len(tail.crossings) == 1
// By symmetry it crosses on the axis: the normal at (x, x²) reaches it at x² + 1/2 after the
// length sqrt(x² + 1/4) = 1.
check tail.crossings[0].point ~= (0, 1.25) within 1e-6

// Sides that fold over: a square of 4 inset by 3, a U closer than twice the distance.
curve square = polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)
curve over = offset(square, -3)
curve u = polyline((0, 4), (0, 0), (1, 0), (1, 4))
curve closed_u = offset(u, -0.75)
// What meets nothing is not warned of.
curve fine = offset(square, -1)
check report(fine) == { operation: "offset", distance: -1, deviation: 0, cusps: [], folds: [], crossings: [] }

// A rounded corner inset by its own radius stands still along the arc.
curve bend = join([line((-2, 0), (0, 0)), arc((0, 1), 1, -90deg, 0deg), line((1, 1), (1, 3))])
curve sharp = offset(bend, -1)
print report(sharp).cusps
check sharp(1.5) ~= (0, 1) within 1e-6
