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
