// Constructions of NURBS take curves that are functions too, and keep the document's tolerance.
geo 1
curve parabola = parametric(t => (t, t^2), 0..2)
curve bell = parametric(t => (1 + t^2, 0, 3*t), 0..1)
curve ring = parametric(t => (2*cos(t), 2*sin(t)), 0..tau)
let places = linspace(0, 1, 7)
surface wall = extrude(parabola, (0, 0, 3))
check every([for f in places: norm(wall(2*f, 1) - (2*f, 4*f^2, 3)) < 1e-6])
surface turned = revolve(bell)
check every([for f in places: abs(hypot(turned(0.3, f).x, turned(0.3, f).y) - (1 + f^2)) < 1e-6])
surface between = ruled(parabola, line((0, 0, 1), (2, 0, 1)))
check every([for f in places: norm(between(2*f, 0.5) - (2*f, 2*f^2, 0.5)) < 1e-6])
surface swinging = swung(bell, ring)
check every([for f in places: norm(swinging(f, pi/2) - (0, 2*(1 + f^2), 3*f)) < 1e-5])
let alike = compatible([parabola, line((0, 0), (1, 1))])
check alike[0].knots == alike[1].knots
