curve c = bezier((0,0),(1,2),(3,1),(4,0))
// Said at once, though nobody draws or measures them.
curve a = parametric(t => frame(c, t).origin, 0..1)
surface b = parametric((u, v) => (u, v, frame(c, u).origin.x), 0..1, 0..1)
curve e = parametric(t => osculating_circle(c, t)(0.5), 0..1)
curve g = parametric(t => c(t) + (0, len(intersect(c, line((t, -1), (4, 3))))), 0..1)
// At single places there may be none.
curve roof = parametric(t => (t, abs(t - 0.5)), 0..1)
print roof(0.25)
// At the center of curvature the nearest place is none that moves smoothly.
curve w = parametric(t => closest(circle((0, 0), 1), (t, t)).point, 0..1)
print derivative(w, 0)
