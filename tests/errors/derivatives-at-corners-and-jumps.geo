let bend = polyline((0, 0), (1, 0), (1, 2))
print gradient(t => bend(t).x, 1)
print gradient(x => length(bend, range = 0..x), 1)
print gradient(p => closest(bend, p).point.y, (2, 0))
