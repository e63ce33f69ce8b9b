// Sections are complete: no loop is too small, touches and branches are told.

let top = plane((0, 0, 1), (0, 0, 1))
let at = z => plane((0, 0, z), (0, 0, 1))

// A circle of radius 0.0045 beside the pole of a sphere, and of a spline near a sphere.
let radius = 0.0045
curves tiny = section(sphere((0, 0), 1), at(sqrt(1 - radius^2)))
check len(tiny) == 1
check length(tiny[0]) ~= tau * radius within 1e-6
surface ball = to_nurbs(parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2), 1e-9)
check not ball.rational
curves spline_tiny = section(ball, at(sqrt(1 - radius^2)))
check len(spline_tiny) == 1 and spline_tiny[0].closed
check length(spline_tiny[0]) ~= tau * radius within 1e-5

// One raised control point of 40 x 40: a bump 4/3 high.
let net = [for i in 0..39: [for j in 0..39: (i, j, if i == 21 and j == 17 then 3 else 0)]]
surface bump = clamped(net)
curves loop = section(bump, at(1.3))
check len(loop) == 1 and loop[0].closed
check length(loop[0]) < 1
check section(bump, at(1.34)) == []

// A plane tangent to a torus outside touches a circle, inside it cuts a figure eight.
let ring = torus((0, 0), 3, 1)
check [for c in section(ring, top): length(c)] ~= [6*pi] within 1e-5
print [for c in section(ring, plane((2, 0), (1, 0, 0))): c.closed]
// Four branches leave a saddle.
print [for c in section(bilinear((-1, -1, 1), (-1, 1, -1), (1, -1, -1), (1, 1, 1)), XY): length(c)] ~= [1, 1, 1, 1] within 1e-6
// A plane that holds a side, a plane that holds the patch, and one that misses.
print [for c in section(plane_patch((0, 0), (2, 0), (0, 3)), YZ): length(c)]
print [for c in section(plane_patch((0, 0), (2, 0), (0, 3)), XY): length(c)]
print section(ring, at(1.5)), section(line((0, 0, 1), (1, 1, 2)), XY)
// A function is cut as a spline within the tolerance; a mesh triangle by triangle.
check [for c in section(parametric((u, v) => (u, v, u^2 + v^2), -2..2, -2..2), top): length(c)] ~= [tau] within 1e-5
check [for c in section(tessellate(box((0, 0, 0), (1, 1, 1))), at(0.25)): length(c)] ~= [4]
check len(section([ring, line((3, 0, 0), (3, 0, 2)), grid_mesh(ring, 24, 12)], at(0.5))) == 5
check len(contours(ring, (0, 0, 2), [-0.5, 0, 0.5, 1.5])) == 6
