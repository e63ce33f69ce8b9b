/// Documentation of what follows.
point p = (1, 2)
curve c = bezier(p, (3, 4))
surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1))
points corners = [(0, 0), (1, 1)]
curves pair = [c, c]
surfaces none_yet = []
table t = table({ a: [1] })
curve bezier((0, 0), (1, 2), (2, 0)) with (color = "#6688aa", layer = "hull", hidden = true)
print p, c, s, corners, pair, t
export all to "all.json"
