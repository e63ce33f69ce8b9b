curve c = bezier((0,0),(1,2),(3,1),(4,0))
curve a = parametric(t => frame(c, t).origin, 0..1)
print length(a)
surface b = parametric((u, v) => (u, v, frame(c, u).origin.x), 0..1, 0..1)
print area(b)
curve e = parametric(t => osculating_circle(c, t)(0.5), 0..1)
export e to "e.obj"
curve g = parametric(t => c(t) + (0, len(intersect(c, line((t, -1), (4, 3))))), 0..1)
print length(g)
// At the center of curvature the nearest place is none that moves smoothly.
curve w = parametric(t => closest(circle((0, 0), 1), (t, t)).point, 0..1)
print derivative(w, 0)
