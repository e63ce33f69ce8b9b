// Surfaces cross in curves, curves pierce surfaces: complete, and by closed forms.

let ball = sphere((0, 0), 5)

// A plane cuts a sphere in a circle, far from its middle in a small one.
fn floor(z) = plane_patch((-9, -9, z), (18, 0), (0, 18))
check [for z in [0, 3, 4.9999]: length(intersect(ball, floor(z))[0])] ~= [10*pi, 8*pi, tau*sqrt(25 - 4.9999^2)] within 1e-5
check every(intersect(ball, floor(3)), c => c.closed)
print intersect(ball, floor(5.01))

// Two spheres cross in a circle: radius 4 where their middles are 6 apart.
curves circle_of_two = intersect(ball, sphere((6, 0), 5))
check len(circle_of_two) == 1
check length(circle_of_two[0]) ~= 8*pi within 1e-5
check every(sample(circle_of_two[0], 30), p => p.x ~= 3 within 2e-6)

// A thin pipe through a thick one: two loops. Viviani: a cylinder that touches a sphere inside
// crosses itself there.
curves saddle = intersect(cylinder((0, 0, -3), 1, 6), cylinder((-3, 0), 0.5, 6, axis = (1, 0, 0)))
check len(saddle) == 2 and every(saddle, c => c.closed)
check every(saddle, c => every(sample(c, 30), p => p.x^2 + p.y^2 ~= 1 within 1e-5 and p.y^2 + p.z^2 ~= 0.25 within 1e-5))

// Waves over a plane, ten loops and no less.
let waves = parametric((u, v) => (u, v, sin(3*u)*sin(3*v)), 0..pi, 0..pi)
check len(intersect(to_nurbs(waves, 1e-8), plane_patch((-1, -1, 0.5), (6, 0), (0, 6)))) == 5

// A bump that is higher than the plane in one small place.
let bump = clamped([for i in 0..19: [for j in 0..19: (i, j, if i == 11 and j == 7 then 3 else 0)]])
curves islet = intersect(bump, plane_patch((-1, -1, 1.3), (30, 0), (0, 30)))
check len(islet) == 1 and islet[0].closed

// Curves and surfaces.
print intersect(line((0, 0, -9), (0, 3, -9) + (0, -3, 18)), floor(0))
check [for m in intersect(line((-10, 1, 2), (10, 1, 2)), ball): m.point.x] ~= [-sqrt(20), sqrt(20)]
check [for m in intersect(ball, line((-10, 1, 2), (10, 1, 2))): m.t] ~= [0.5 - sqrt(20)/20, 0.5 + sqrt(20)/20]
check [for m in intersect(helix((0, 0, -1), 3, 1, 4), floor(0)): m.t] ~= [0.25] within 1e-6
// A tangent touches in one place.
check [for m in intersect(line((-10, 0, 5), (10, 0, 5)), ball): m.t] ~= [0.5] within 1e-6
print intersect(line((-10, 0, 6), (10, 0, 6)), ball)
