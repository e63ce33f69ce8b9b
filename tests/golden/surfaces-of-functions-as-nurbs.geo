// A function of two parameters as a spline, within the tolerance wherever it is compared.
surface ball = parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..2*pi, -pi/2..pi/2)
surface near = to_nurbs(ball, 1e-5)
let places = [for i in 0..23, j in 0..23: (2*pi*i/23, pi*j/23 - pi/2)]
check every(places, f = p => distance(near(p.x, p.y), ball(p.x, p.y)) < 1e-5)
check near.degree_u == 5 and near.domain_v.end == pi/2
check bounds(ball).min ~= (-1, -1, -1) within 2e-8
check bounds(ball).max ~= (1, 1, 1) within 2e-8
check length(ball(_, 0)) ~= 2*pi within 1e-12
check length(ball(0.5, _)) ~= pi within 1e-12
mesh facets = tessellate(ball, tolerance = 0.05)
check every(facets.vertices, f = p => norm(p) ~= 1 within 1e-14)
// Of the nine vertices at each pole one belongs to no triangle.
check len(grid_mesh(ball, 8, 4).vertices) == 43

// Polynomials up to the fifth power are met exactly.
surface saddle = to_nurbs(parametric((u, v) => (u, v, u*v^3), -1..1, 0..2), 1e-9)
check saddle(0.3, 1.7) ~= (0.3, 1.7, 0.3*1.7^3) within 1e-13

// Creases along parameter lines are kept.
surface roof = to_nurbs(parametric((u, v) => (u, v, abs(u - 0.3) + v^2), 0..1, 0..1), 1e-6)
check roof(0.3, 0.5) ~= (0.3, 0.5, 0.25) within 1e-6
check roof(0.30001, 0.5) ~= (0.30001, 0.5, 0.25001) within 1e-6
check len([for k in roof.knots_u if k ~= 0.3 within 1e-12: k]) == 5
surface tub = parametric((u, v) => (u, v, sqrt(1 - u^2)), 0..1, 0..1)
check bounds(tub).max ~= (1, 1, 1) within 1e-5
