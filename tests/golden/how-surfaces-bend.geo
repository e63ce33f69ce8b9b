// do Carmo, Differential Geometry of Curves and Surfaces, 3-3; Linkeova, Example 1.7.
let r = 2
surface torus = parametric((u, v) => ((3 + cos(v))*cos(u), (3 + cos(v))*sin(u), sin(v)), 0..tau, 0..tau)
check every([for v in linspace(0, tau, 9): abs(gaussian(torus, 1, v) - cos(v)/(3 + cos(v))) < 1e-14])
check every([for v in linspace(0, tau, 9): abs(mean(torus, 1, v) + (1 + cos(v)/(3 + cos(v)))/2) < 1e-14])
check principal(torus, 0, 0).k1 ~= -1 within 1e-15
check principal(torus, 0, 0).k2 ~= -1/4 within 1e-15
check principal(torus, 0, 0).d1 ~= (0, 0, 1) within 1e-15

// The poles of a sphere are places like all others, though singular ones.
surface ball = parametric((u, v) => (r*cos(u)*cos(v), r*sin(u)*cos(v), r*sin(v)), 0..tau, -pi/2..pi/2)
check every([for v in linspace(-pi/2, pi/2, 5): abs(gaussian(ball, 1, v) - 1/r^2) < 1e-14])
check every([for v in linspace(-pi/2, pi/2, 5): abs(mean(ball, 1, v) + 1/r) < 1e-14])
check classify(ball, 1, pi/2) == "singular"
check tangent_u(ball, 0, pi/2) ~= (0, 1, 0) within 1e-15 "the limit along the meridian"
check tangent_v(ball, 0, pi/2) ~= (-1, 0, 0) within 1e-15
check tangent_plane(ball, 1, pi/2).z ~= (0, 0, 1) within 1e-15
check normal_curvature(ball, 1, 0.3, (1, 2, 3)) ~= -1/r within 1e-14

// Developable: a cone, a cylinder, the tangents of a helix.
surface cone = parametric((u, v) => ((1 - v)*cos(u), (1 - v)*sin(u), v), 0..tau, 0..1)
surface tangents = parametric((u, v) => (cos(u) - v*sin(u), sin(u) + v*cos(u), u + v), 0..5, 0.5..2)
check abs(gaussian(cone, 2, 0.9)) < 1e-13 and abs(gaussian(tangents, 2, 1)) < 1e-14
check classify(cone, 2, 0.9) == "parabolic" and classify(tangents, 2, 1) == "parabolic"
check classify(cone, 2, 1) == "singular"

// Minimal: Enneper's surface is a bicubic.
surface enneper = parametric((u, v) => (u - u^3/3 + u*v^2, v - v^3/3 + v*u^2, u^2 - v^2), -1..1, -1..1)
check every([for u in linspace(-1, 1, 5), v in linspace(-1, 1, 5): abs(mean(enneper, u, v)) < 1e-15])
check every([for u in linspace(-1, 1, 5), v in linspace(-1, 1, 5): abs(gaussian(enneper, u, v) + 4/(1 + u^2 + v^2)^4) < 1e-14])

// A planar point, and a plane.
surface monkey = parametric((u, v) => (u, v, u^3 - 3*u*v^2), -1..1, -1..1)
surface plate = bilinear((0, 0), (0, 2), (3, 0), (3, 2))
check classify(monkey, 0, 0) == "planar" and classify(monkey, 0.5, 0) == "hyperbolic"
check classify(plate, 0.1, 0.7) == "planar"
check first_form(plate, 0, 0) == {E: 9, F: 0, G: 4}
check second_form(plate, 0, 0) == {L: 0, M: 0, N: 0}

// Whichever way the parameters run, K stays and H turns its sign.
surface turned = parametric((u, v) => torus(v, u), 0..tau, 0..tau)
check gaussian(turned, 1, 2) ~= gaussian(torus, 2, 1) within 1e-15
check mean(turned, 1, 2) ~= -mean(torus, 2, 1) within 1e-15

table samples = curvature_table(cone, u = 3, v = 3)
check len(samples) == 9
check samples.k1[1] ~= -0.5^0.5/0.5 within 1e-14
check samples.k1[2] == none and samples.nx[2] != none "the apex has a normal on each meridian, and no curvature"
print samples[0]
