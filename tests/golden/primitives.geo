// The primitives: where they lie, how they run, and that they look outward.
geo 1

surface ball = sphere((1, 2, 3), 2)
check ball(0, 0.5) ~= (3, 2, 3) within 1e-15
check ball(0.25, 0.5) ~= (1, 4, 3) within 1e-15
check ball(0.4, 0) ~= (1, 2, 1) within 1e-15
check ball(0.4, 1) ~= (1, 2, 5) within 1e-15
check [for u in linspace(0, 1, 9), v in linspace(0, 1, 9): normal(ball, u, v)]
    ~= [
        for u in linspace(0, 1, 9), v in linspace(0, 1, 9): (ball(u, v) - (1, 2, 3)) / 2
    ] within 1e-12
check ball.closed_u and not ball.closed_v
check bounds(ball).min ~= (-1, 0, 1) within 1e-14
check [ball.degree_u, ball.degree_v] == [2, 2]

// x of an axis is (1, 0, 0) made normal to it, or (0, 1, 0).
surface post = cylinder((0, 0, 1), 2, 6, axis = (0, 0, 3))
check [post(0, 0), post(0.25, 0.5), post(0, 1)] ~= [(2, 0, 1), (0, 2, 4), (2, 0, 7)] within 1e-15
check normal(post, 0.25, 0.3) ~= (0, 1, 0) within 1e-15
surface beam = cylinder((0, 0, 1), 2, 6, axis = (1, 0, 0))
check [beam(0, 0), beam(0.25, 0.5)] ~= [(0, 2, 1), (3, 0, 3)] within 1e-15

surface tip = cone((0, 0), 3, 0, 4)
check tip(0.6, 1) ~= (0, 0, 4)
check normal(tip, 0, 0.5) ~= (0.8, 0, 0.6) within 1e-15
check cone((0, 0), 1, 2, 4)(0.5, 0.5) ~= (-1.5, 0, 2) within 1e-15
surface funnel = cone((0, 0), 0, 2, 1)
check normal(funnel, 0, 0.5) ~= (1/sqrt(5), 0, -2/sqrt(5)) within 1e-15

surface ring = torus((0, 0, 1), 3, 1)
check [ring(0, 0), ring(0, 0.25), ring(0, 0.5), ring(0.25, 0)]
    ~= [(4, 0, 1), (3, 0, 2), (2, 0, 1), (0, 4, 1)] within 1e-15
check normal(ring, 0.25, 0.25) ~= (0, 0, 1) within 1e-15
check ring.closed_u and ring.closed_v

let sides = box((1, 2, 3), (4, 5, 6))
check [for side in sides: normal(side, 0.3, 0.6)]
    ~= [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]
check bounds(sides).min == (1, 2, 3) and bounds(sides).max == (5, 7, 9)
check [for side in sides: side(0.5, 0.5)]
    ~= [(1, 4.5, 6), (5, 4.5, 6), (3, 2, 6), (3, 7, 6), (3, 4.5, 3), (3, 4.5, 9)]

surface plate = disc(plane((1, 0, 0), (1, 0, 0)), 2)
check normal(plate, 0.3, 0.5) ~= (1, 0, 0) within 1e-15
check plate(0, 0) ~= (1, 2, 0) within 1e-15
surface tile = plane_patch((1, 1, 1), (2, 0, 0), (0, 3, 0))
check tile(0.5, 1) ~= (2, 4, 1)
check normal(tile, 0, 0) ~= (0, 0, 1)
check hyperbolic_paraboloid((0, 0), (0, 1), (1, 0), (1, 1, 1))(0.5, 0.5) ~= (0.5, 0.5, 0.25)

// Closed: no gap between the sides of a mesh made of all.
print len(tessellate(sides).triangles)
