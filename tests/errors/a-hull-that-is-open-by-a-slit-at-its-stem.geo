let port = bezier([[(0, 0.001, 0), (0, 0.001, 300)], [(500, 0, 0), (500, 200, 300)], [(1000, 0, 0), (1000, 0, 300)]])
let starboard = mirror(port, ZX)
print volume([port, starboard, ruled(port(_, 1), starboard(_, 1))])
