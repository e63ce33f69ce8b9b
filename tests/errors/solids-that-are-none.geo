geo 1
region disc = region(circle((3, 0), 1))

print solid(cylinder((0, 0), 1, 3))
print solid([sphere((0, 0), 1), sphere((1, 0), 1)])
print solid(trim(cylinder((0, 0), 1, 3), by = sphere((1, 0, 3), 1.5), keep = (-1, 0, 0)), cap = true)
print extrude(disc, (1, 0, 0))
print revolve(disc)
print revolve(disc, axis = (0, 1, 0), about = (2.5, 0))
print revolve(disc, axis = (0, 1, 0), about = (2, 0))
print solid(grid_mesh(sphere((0, 0), 1), 4, 4))
solid s = sphere((0, 0), 1)
print volume(solid(cylinder((0, 0, 0), 1, 1e-7), cap = true))
let corners = difference(region(polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)), [
    region(polyline([(1, 1), (2, 1), (2, 2), (1, 2)], closed = true)),
    region(polyline([(2, 2), (3, 2), (3, 3), (2, 3)], closed = true)),
])
print volume(extrude(corners[0], (0, 0, 1)))
print solid(extrude(polyline([(0, 0), (2, 2), (2, 0), (0, 1)], closed = true), (0, 0, 1)), cap = true)
print solid(revolve(circle((0.5, 0), 1), axis = (0, 1, 0)))
