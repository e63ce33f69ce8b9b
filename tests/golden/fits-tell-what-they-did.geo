// The parameters of a grid's points are the fractions of their distances.
let grid = [for x in [0, 1, 4]: [for y in [0, 3, 4]: (x, y, 0)]]
let through = report(interpolate(grid, degree = 2))
print through.operation, through.parameters, through.degree
check through.deviation.max < 1e-14
let bumpy = [for i in 0..6: [for j in 0..6: (i, j, sin(i*1rad)*cos(j*1rad))]]
surface near = approximate(bumpy, control_points = 5)
let told = report(near)
let at = told.deviation.at
print told.control_points
check told.deviation.max ~= norm(near(at.u, at.v) - bumpy[round(6*at.u)][round(6*at.v)]) within 0.2
check told.deviation.mean <= told.deviation.max
// Functions, and what is a NURBS already.
let s = report(to_nurbs(parametric(t => (t, sin(t*1rad)), 0..6), 1e-4))
check s.deviation.max <= 1e-4 and s.deviation.max > 0
print s.degree
print report(to_nurbs(circle((0, 0), 1), 1e-4)).deviation
let f = report(to_nurbs(parametric((u, v) => (u, v, sin(u*v*1rad)), 0..2, 0..2), 1e-4))
check f.deviation.max <= 1e-4
print f.degree
