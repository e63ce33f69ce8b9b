// A length that grows from nothing is a function with derivatives from its start on.
geo 1

curve c = bezier((0, 0), (1, 2), (2, 0))
check length(c, range = 0..0) == 0
check length(c, range = 0.5..0.5) == 0
check length(c, range = 1..1) == 0
curve grown = parametric(t => (t, length(c, range = 0..t)), domain = 0..1)
check grown.end ~= (1, length(c))
check tangent(grown, 0).y / tangent(grown, 0).x ~= norm(derivative(c, 0)) within 1e-9
check length(grown) ~= length(to_nurbs(grown, 1e-9)) within 1e-6
