// A ceiling may be reached, of curves and of both directions of surfaces.
points p = [for i in 0..100: (i, i % 3)]
curve c = bezier(p)
check c.degree == 100
check c.start == (0, 0) and c.end == (100, 1)
// The middle of a Bernstein sum of x = i is 50.
check c(0.5).x ~= 50
surface s = extrude(c, (0, 0, 1))
check s.degree_u == 100 and s.degree_v == 1
