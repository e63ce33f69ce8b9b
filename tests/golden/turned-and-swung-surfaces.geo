// Surfaces that a curve leaves behind.
geo 1

// A quarter of a ring: u around the axis, v along the curve on the curve's own domain.
curve side = polyline((2, 0, 0), (3, 0, 0), (3, 0, 1))
surface ring = revolve(side, angle = 90deg)
check ring.domain_u == 0..1
check ring.domain_v == 0..2
check ring.patches == [1, 2]
check ring(0, 1.5) ~= side(1.5)
check ring(1, 1.5) ~= (0, 3, 0.5) within 1e-15
check ring(0.5, 0) ~= (sqrt(2), sqrt(2), 0) within 1e-15

// The other way around, about another axis.
surface back = revolve(side, axis = (0, 0, -2), about = (1, 0, 0), angle = 90deg)
check back(1, 0) ~= (1, -1, 0) within 1e-15
check revolve(side, about = (1, 0, 0), angle = -90deg)(0.3, 1.2) ~= back(0.3, 1.2) within 1e-15

// A rational curve turned is a torus, and has its curvature; more than half a turn takes three arcs.
surface tube = revolve(circle((5, 0, 0), 1, normal = (0, -1, 0)), angle = 200deg)
check tube.patches == [3, 4]
check tube.closed_v and not tube.closed_u
check [for u in linspace(0, 1, 7), v in linspace(0, 1, 7):
    hypot(hypot(tube(u, v).x, tube(u, v).y) - 5, tube(u, v).z)] ~= [for i in 1..49: 1] within 1e-14

// The profile that crosses the axis makes a surface that passes through itself: a warning.
surface crossed = revolve(line((-1, 0, 0), (3, 0, 4)))
check crossed(0.5, 0.5) ~= (-1, 0, 2) within 1e-15
// A profile that runs along the axis has a part without area: a warning. Poles have none.
surface lid = revolve(polyline((2, 0, 0), (0, 0, 0), (0, 0, 1), (2, 0, 1)))
surface dome = revolve(arc((0, 0), 2, 0deg, 90deg, normal = (0, -1, 0)))
check norm(dome(0.3, 0.7)) ~= 2 within 1e-15
surface spindle = torus((0, 0), 1, 2)

// A square swung: the profile's x scales the trajectory.
surface tower = swung(
    bezier((1, 0, 0), (2, 0, 1), (1, 0, 3)),
    polyline((1, 0), (0, 1), (-1, 0)),
    scale = 2,
)
check tower(0.5, 0.5) ~= 2 * 1.5 * (1/2, 1/2) + (0, 0, 1.25)
check tower.closed_v == false
check swung(line((1, 0, 0), (1, 0, 4)), polyline((1, 0), (0, 1), (-1, 0), closed = true)).closed_v

// A wall and its inclination.
surface wall = extrude(arc((0, 0), 2, 0deg, 180deg), (1, 0, 3))
check wall.domain_u == 0..1
check wall(1, 1) ~= (-1, 0, 3)
check wall(0.5, 0.5) ~= (0.5, 2, 1.5) within 1e-15
