// The document's tolerance counts, also where it is coarse.
tolerance 1e-3
fn screw(t) = (10*cos(t*900deg), 10*sin(t*900deg), 7.5*t)
curve h = helix((0, 0), 10, 3, 2.5)
let misses = [for t in linspace(0, 1, 1001): distance(h(t), screw(t))]
check max(misses) <= 1e-3
check max(misses) > 1e-6 "no finer than asked for"
check h.start == (10, 0, 0)
check h.end ~= (-10, 0, 7.5) within 1e-12
check helix((1, 1, 1), 10, -3, 1).end ~= (11, 1, -2) within 1e-12
