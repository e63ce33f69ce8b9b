unit mm
// A circle, within the tolerance of the document and within a smaller one.
curve circular = ode((t, p) => (-p.y, p.x), start = (1, 0), range = 0..tau)
check circular.end ~= (1, 0) and length(circular) ~= tau
check max([for t in linspace(0, tau, 50): norm(circular(t) - (cos(t), sin(t)))]) < 1e-6
curve near = ode((t, p) => (-p.y, p.x), start = (1, 0), range = 0..tau, tolerance = 1e-11)
check max([for t in linspace(0, tau, 50): norm(near(t) - (cos(t), sin(t)))]) < 1e-11
check report(near).error <= 1e-11 and report(near).steps > report(circular).steps
check report(near).evaluations > 6 * report(near).steps
check derivative(circular, 1) ~= (-sin(1), cos(1)) within 1e-6
check near.degree == 5 and circular.domain == 0..tau

// A clothoid ends where the integrals of Fresnel do: its direction is the third coordinate.
curve turning = ode((s, p) => (cos(p.z), sin(p.z), s), start = (0, 0), range = 0..5)
curve clothoid = project(turning, plane((0, 0), (0, 0, 1)))
check clothoid.end ~= (integrate(s => cos(s^2/2), 0..5), integrate(s => sin(s^2/2), 0..5))
check length(clothoid) ~= 5 and curvature(clothoid, 3) ~= 3 within 1e-4

// A streamline past a cylinder keeps the value of its stream function.
fn flow(p) = { let r = p.x^2 + p.y^2
  (1 - (p.x^2 - p.y^2)/r^2, -2*p.x*p.y/r^2) }
fn stream(p) = p.y * (1 - 1/(p.x^2 + p.y^2))
curves streamlines = [for y in [0.1, 0.5, 1]: ode((t, p) => flow(p), start = (-4, y), range = 0..10)]
check every([for c in streamlines, t in 0..10: abs(stream(c(t)) - stream(c.start)) < 1e-5])
check every([for c in streamlines: c.end.x > 3])

// The units of the variable, and a range that begins elsewhere.
check ode((x, p) => (1, cos(x)), start = (0, 0), range = 0deg..90deg).end ~= (pi/2, 1)
check ode((x, p) => (1, 2 * x / 1mm), start = (2, 4), range = 2mm..3mm).end ~= (3, 9)

// Several points: a planet's place and velocity on an ellipse, once around.
let orbit = ode((t, s) => [s[1], -s[0] / norm(s[0])^3], start = [(1, 0), (0, 1.2)], range = 0..6, tolerance = 1e-9)
curve path = orbit[0]
check derivative(path, 2) ~= orbit[1](2)
fn energy(t) = norm(orbit[1](t))^2 / 2 - 1 / norm(path(t))
check every([for t in 0..6: abs(energy(t) - energy(0)) < 1e-8])

// A geodesic of a unit sphere by its parameters, a great circle: place and direction.
let great = ode((t, s) => [s[1], (2*tan(s[0].y)*s[1].x*s[1].y, -sin(s[0].y)*cos(s[0].y)*s[1].x^2)], start = [(0, 0), (0.8, 0.6)], range = 0..2)
fn on_sphere(p) = (cos(p.y)*cos(p.x), cos(p.y)*sin(p.x), sin(p.y))
check every([for t in linspace(0, 2, 9): norm(on_sphere(great[0](t)) - (cos(t)*(1, 0, 0) + sin(t)*(0, 0.8, 0.6))) < 1e-5])

// A corner where the rate jumps, and what fades at once.
curve corner = ode((t, p) => (1, if t < 0.3 then -1 else 1), start = (0, 0.3), range = 0..1)
check corner(0.3) ~= (0.3, 0) and corner.end ~= (1, 0.7)
check ode((t, p) => (-500*(p.x - cos(t)), 0), start = (2, 0), range = 0..5).end.x ~= cos(5) within 3e-3
// Nothing that moves is one point.
check ode((t, p) => (0, 0), start = (1, 2), range = 0..1)(0.5) == (1, 2)
print report(circular)
