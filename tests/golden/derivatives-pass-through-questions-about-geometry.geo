// Each question about a fixed curve or surface, asked at what moves, against central differences of orders 1 and 2.
curve c = bezier([(0, 0, 0), (1, 2, 1), (3, 1, -1), (4, 0, 2)])
curve q = nurbs([(0, 0), (1, 2), (3, 2), (4, 0)], weights = [1, 2, 0.5, 1], degree = 3)
surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]])
fn x_of(f) = parametric(t => { let y = f(t); (y, 2 * y, 0) }, 0.1..0.9)
fn slopes_are_right(f) = {
  let moving = x_of(f)
  every([0.2, 0.45, 0.7], f = t => {
    let h = 1e-4
    let first = (f(t + h) - f(t - h)) / (2 * h)
    let second = (f(t + h) - 2 * f(t) + f(t - h)) / h^2
    let size = 1 + abs(first) + abs(second)
    abs(derivative(moving, t).x - first) < 1e-5 * size and abs(derivative(moving, t, order = 2).x - second) < 1e-4 * size
  })
}
let way = (1, 2, -0.5)
check slopes_are_right(t => dot(at(c, t^2), way))
check slopes_are_right(t => dot(tangent(c, t), way))
check slopes_are_right(t => dot(normal(c, 1 - t), way))
check slopes_are_right(t => dot(binormal(c, t), way))
check slopes_are_right(t => curvature(c, t) * 1mm)
check slopes_are_right(t => curvature(q, sin(t)) * 1mm)
check slopes_are_right(t => signed_curvature(q, t) * 1mm)
check slopes_are_right(t => signed_curvature(q, t, normal = (0, 1, 5)) * 1mm)
check slopes_are_right(t => signed_curvature(rotate(q, 20deg, axis = (1, 1, 0)), t, normal = rotate((0, 0, 1), 20deg, axis = (1, 1, 0))) * 1mm)
check slopes_are_right(t => radius_of_curvature(q, t))
check slopes_are_right(t => torsion(c, t) * 1mm)
check slopes_are_right(t => dot(center_of_curvature(q, t), way))
check slopes_are_right(t => dot(derivative(c, t, order = 2), way))
check slopes_are_right(t => length(c, range = 0..t))
check slopes_are_right(t => length(c, range = t..1))
check slopes_are_right(t => length(q, range = t^2..t))
check slopes_are_right(t => parameter_at_length(c, 2 * t))
check slopes_are_right(t => closest(q, (4 * t, 3 - t, 1)).t)
check slopes_are_right(t => dot(closest(c, (4 * t, 1, 0.3)).point, way))
check slopes_are_right(t => closest(q, (4 * t, 3, 1 + t)).distance)
check slopes_are_right(t => dot(at(s, t, t^2), way))
check slopes_are_right(t => dot(normal(s, t, 0.3), way))
check slopes_are_right(t => dot(normal(s, 0.6, 1 - t), way))
check slopes_are_right(t => dot(tangent_u(s, t, t), way))
check slopes_are_right(t => dot(tangent_v(s, t, t), way))
check slopes_are_right(t => dot(derivative(s, t, t / 2, du = 1, dv = 1), way))
check slopes_are_right(t => dot(twist(s, t, 1 - t), way))
check slopes_are_right(t => gaussian(s, t, 0.4) * 1mm^2)
check slopes_are_right(t => mean(s, t, t / 3) * 1mm)
check slopes_are_right(t => principal(s, t, 0.3).k1 * 1mm)
check slopes_are_right(t => principal(s, t, 0.3).k2 * 1mm)
check slopes_are_right(t => dot(principal(s, t, 0.3).d1, way))
check slopes_are_right(t => dot(principal(s, t, 0.3).d2, way))
check slopes_are_right(t => normal_curvature(s, t, 0.3, (1, t, 0)) * 1mm)
check slopes_are_right(t => normal_curvature(s, 0.4, 0.3, (1, t, 0)) * 1mm)
check slopes_are_right(t => first_form(s, t, 0.3).F / 1mm^2)
check slopes_are_right(t => second_form(s, t, t).M)
check slopes_are_right(t => closest(s, (4 * t, 1, 3)).u)
check slopes_are_right(t => closest(s, (4 * t, 1 + t, 3)).v)
check slopes_are_right(t => closest(s, (4 * t, 1 + t, 3)).distance)
check slopes_are_right(t => dot(closest(s, (4 * t, -1, t)).point, way))
check slopes_are_right(t => closest(s, (-1, -1 - t, t)).distance)

// The evolute of the parabola y = x² is (-4x³, 1/2 + 3x²); its length is the difference of the radii.
curve parabola = bezier((-1, 1), (0, -1), (1, 1))
curve evolute = parametric(t => center_of_curvature(parabola, t), 0..1)
check evolute(0.75) ~= (-0.5, 1.25) within 1e-12
check length(evolute, range = 0.5..1) ~= (5^1.5 - 1) / 2 within 1e-12
check length(evolute, range = 0.5..1) ~= radius_of_curvature(parabola, 1) - radius_of_curvature(parabola, 0.5) within 1e-12
// That of an ellipse, and its whole length 4 (a²/b - b²/a).
curve e = ellipse((0, 0), 3, 2)
curve astroid = parametric(t => center_of_curvature(e, t), e.domain)
check length(astroid) ~= 4 * (9/2 - 4/3) within 1e-9

// An offset by hand is the offset; a circle's is a circle.
curve o = parametric(t => q(t) + 0.2 * normal(q, t), 0..1)
check length(o) ~= length(offset(q, 0.2)) within 1e-5
curve ring = parametric(t => { let r = circle((1, 1), 2); r(t) + 0.5 * normal(r, t) }, 0..1)
check curvature(ring, 0.3) ~= 1 / 1.5 within 1e-12
check length(ring) ~= 3 * pi within 1e-12

// The involute of a circle: of curvature 1/s.
curve wheel = circle((0, 0), 1)
curve involute = parametric(t => wheel(t) - length(wheel, range = 0..t) * tangent(wheel, t), 0.1..1)
check every([0.2, 0.5, 0.9], f = t => abs(curvature(involute, t) * length(wheel, range = 0..t) - 1) < 1e-10)

// By arc length the speed is 1.
curve by_length = parametric(l => c(parameter_at_length(c, l)), 0..length(c))
check every([0.3, 1.7, 4], f = l => abs(norm(derivative(by_length, l)) - 1) < 1e-12)
check curvature(by_length, 2) ~= curvature(c, parameter_at_length(c, 2)) within 1e-10

// Curves on surfaces, offset surfaces by hand.
surface shell = parametric((u, v) => s(u, v) + 0.3 * normal(s, u, v), 0..1, 0..1)
check normal(shell, 0.3, 0.6) ~= normal(s, 0.3, 0.6) within 1e-12
surface ball = sphere((0, 0), 1)
surface blown = parametric((u, v) => ball(u, v) + 0.5 * normal(ball, u, v), 0..1, 0.1..0.9)
check area(blown) ~= 2 * pi * 1.5^2 * (ball(0, 0.9).z - ball(0, 0.1).z) within 1e-9

// The curvature of a straight line is 0 all along.
curve flat = parametric(t => (t, curvature(line((0, 0), (1, 3)), t) / 1mm^-1), 0..1)
check length(flat) ~= 1 within 1e-12
// Curves of what was measured are drawn and exported like any others.
export [evolute, o, involute] to "curves.obj" with (tolerance = 1e-3)
print describe(involute).kind, len(tessellate(shell, tolerance = 0.01).triangles) > 10
