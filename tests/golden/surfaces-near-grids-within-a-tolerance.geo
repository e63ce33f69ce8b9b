geo 1

// A smooth surface within a tolerance: every point, with far fewer control points than points.
let places = [for i in 0..40: [for j in 0..30: (i / 10, j / 10, sin(i / 10 * 1rad) * cos(j / 10 * 1rad))]]
fn near(distance) = approximate(places, tolerance = distance)
fn misses(s) = {
  let at = report(s).parameters
  max([for i in 0..40: max([for j in 0..30: norm(s(at.u[i], at.v[j]) - places[i][j])])])
}
let coarse = near(1e-2)
let fine = near(1e-4)
check misses(coarse) <= 1e-2 and misses(fine) <= 1e-4
check report(coarse).deviation.max ~= misses(coarse)
check len(coarse.points) * len(coarse.points[0]) <= 36
check len(fine.points) * len(fine.points[0]) <= 200
check coarse(0, 0) == places[0][0] and coarse(1, 1) == places[40][30]

// A polynomial of the degree needs no knot, whatever the tolerance.
let graph = [for i in 0..12: [for j in 0..9: (i, j, i^3 - 2 * i * j^2)]]
let listed = {u: [for i in 0..12: i], v: [for j in 0..9: j]}
let exact = approximate(graph, tolerance = 1e-8, parameters = listed)
check report(exact).control_points == {u: 4, v: 4}
check exact(3, 5) ~= (3, 5, 27 - 150)

// A ridge along v takes knots along u alone.
let ridge = [for i in 0..40: [for j in 0..30: (i, j, if i < 20 then 0 else i - 20)]]
let bent = approximate(ridge, tolerance = 1e-3)
check len(bent.points[0]) == 4
check report(bent).deviation.max <= 1e-3

// By other degrees, and by rows of control points.
let flat = approximate(places, degree = {u: 2, v: 1}, tolerance = 0.05, second_pass = "control")
check report(flat).deviation.max <= 0.05
check flat.degree_u == 2 and flat.degree_v == 1
