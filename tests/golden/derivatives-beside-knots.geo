let bend = polyline((0, 0), (1, 0), (1, 1))
// Held at the corner from both sides, the nearest point does not move.
check gradient(p => closest(bend, p).point.y, (2, -1)) == (0, 0, 0)
check gradient(p => closest(bend, p).distance, (2, -1)) ~= unit_vector((1, -1))
check gradient(p => closest(bend, p).point.y, (2, 0.5)) ~= (0, 1, 0)
// Legs of one length have one speed; nothing bends where they go straight on, or where splines have a knot.
check gradient(x => length(bend, range = 0..x), 1) ~= 1
check gradient(t => polyline((0, 0), (1, 0), (2, 0))(t).x, 1) ~= 1
curve c = clamped((0, 0), (1, 2), (3, 2), (4, 0), (5, 1))
check gradient(t => c(t).y, 1) ~= derivative(c, 1).y
check gradient(t => derivative(c, t).y, 1) ~= derivative(c, 1, order = 2).y
// At one of its ends a curve goes on to one side alone.
check gradient(t => bend(t).x, 0) ~= 1
