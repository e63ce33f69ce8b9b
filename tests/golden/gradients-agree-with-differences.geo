unit mm
// What is measured of geometry that varies has the derivatives that differences of its values tend to.
fn arch(a) = bezier((0, 0), (1, 2 + a, 0.3), (3, a, 1), (4, 0.5))
fn shell(a) = bezier([[(0, 0, 0), (0, 2, a), (0, 4, 0)], [(2, 0, 1), (2, 2, 3 + a), (2, 4, 1)], [(4, 0, a), (4, 2, 1), (4, 4, 0)]])
fn ball(a) = sphere((0.1, a, 0), a)
let of_curves = [
  a => length(arch(a)),
  a => length(arch(a), range = 0.2..0.7),
  a => length(arch(1), range = 0..0.3 * a),
  a => arch(a)(0.3 * a).y,
  a => derivative(arch(a), 0.4).y,
  a => tangent(arch(a), 0.4).x,
  a => normal(arch(a), 0.4).y,
  a => binormal(arch(a), 0.4).x,
  a => curvature(arch(a), 0.4),
  a => radius_of_curvature(arch(a), 0.4),
  a => torsion(arch(a), 0.4),
  a => center_of_curvature(arch(a), 0.4).y,
  a => parameter_at_length(arch(a), 2),
  a => closest(arch(a), (2, 2)).t,
  a => closest(arch(a), (2, 2)).point.y,
  a => closest(arch(a), (2, 2, a)).distance,
  a => closest(arch(1), (2, 2, a)).distance,
]
let of_surfaces = [
  a => area(shell(a)),
  a => volume(ball(a)),
  a => centroid(ball(a)).y,
  a => centroid(shell(a), of = "area").z,
  a => shell(a)(0.3, 0.2 * a).z,
  a => derivative(shell(a), 0.3, 0.6).z,
  a => normal(shell(a), 0.3, 0.6).y,
  a => tangent_u(shell(a), 0.3, 0.6).z,
  a => tangent_v(shell(a), 0.3, 0.6).z,
  a => gaussian(shell(a), 0.3, 0.6),
  a => mean(shell(a), 0.3, 0.6),
  a => principal(shell(a), 0.3, 0.6).k1,
  a => first_form(shell(a), 0.3, 0.6).E,
  a => closest(ball(a), (2, 1, 3)).distance,
  a => closest(ball(a), (2, 1, 3)).point.y,
  a => closest(shell(a), (2, 2, 9)).distance,
  a => closest(shell(a), (2.2, 1.8, 9)).u,
  a => closest(shell(a), (2.2, 1.8, 9 * a)).point.z,
]
fn off(f, at) = {
  let [exact, near] = [gradient(f, at), gradient(f, at, differences = true)]
  abs(exact - near) / (abs(exact) + abs(near))
}
check every(of_curves, f = f => off(f, 1.1) < 1e-6)
check every(of_surfaces, f = f => off(f, 1.1) < 1e-6)

// Steps under integrals that move with what derivatives are by.
fn cut(a) = integrate(x => (if a * x < 0.3 then x^2 else 2 - x) + floor(a * x * 4) + (3*x) % a, 0..1)
check gradient(cut, 0.7) ~= gradient(cut, 0.7, differences = true) within 1e-6
fn pond(u) = integrate(x => max(0, u.level - x^2), -1..1)
check gradient(u => pond(u), {level: 0.5}).level ~= sqrt(2)
fn bank(u) = integrate((x, y) => if x + y < u.edge then u.level * x^2 else 1, [-1..1, -1..1], tolerance = 1e-6)
check gradient(u => bank(u), {level: 0.5, edge: 0.25}).edge ~= 0.5 * (1 + 0.75^3) / 3 - 1.75
fn heading(s) = if s < 80 then 0 else if s < 155 then (s - 80)^2 / 45000 else 0.125 + (s - 155) / 300
curve road = parametric(s => s * integrate(k => (cos(heading(k*s)), sin(heading(k*s))), 0..1), 0..300)
check [for s in [60, 100, 200, 300]: derivative(road, s, order = 2).y] ~= [for s in [60, 100, 200, 300]: (heading(s + 0.01) - heading(s - 0.01)) / 0.02 * cos(heading(s))] within 1e-6
// Each of its points is an integral with a kink.
check length(parametric(s => road(s), 75..85)) ~= 10
fn half(a) = integrate(p => if p.x < a then 1 else 0, region(circle((0, 0), 1)), tolerance = 1e-7)
check gradient(half, 0.6) ~= 1.6 within 1e-5

// Inertia and trajectories.
fn wedge(u) = ruled(polyline([(0, 0), (u.a, 0.2), (1, 2), (0, u.b)], closed = true), polyline([(0, 0, u.a), (1, 0.1, 2), (1.1, 2, 2), (0, 1, u.b)], closed = true))
fn skin_of(u) = inertia(wedge(u), of = "area")
let sides = {a: 1.3, b: 1.7}
fn same(f) = { let [a, b] = [gradient(f, sides), gradient(f, sides, differences = true)]  max(abs(a.a - b.a), abs(a.b - b.b)) < 1e-5 * (1 + abs(b.a) + abs(b.b)) }
check same(u => skin_of(u).tensor[0][1]) and same(u => skin_of(u).tensor[2][2]) and same(u => skin_of(u).moments[1]) and same(u => skin_of(u).axes[2].x)
fn block(u) = inertia(rotate(box((0, 0, 0), (u.a, u.b, 3)), 20deg, axis = (1, 2, 3)))
check same(u => block(u).tensor[0][2]) and same(u => block(u).moments[0]) and same(u => block(u).axes[1].y)
fn shot(u) = ode((t, s) => [s[1], (-u.a * norm(s[1]) * s[1].x, -9.81 - u.a * norm(s[1]) * s[1].y)], start = [(0, 0), (3, u.b)], range = 0..1, tolerance = 1e-10)[0]
check same(u => shot(u).end.x) and same(u => shot(u)(0.6).y) and same(u => length(shot(u)))
