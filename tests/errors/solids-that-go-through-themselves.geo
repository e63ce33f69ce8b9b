geo 1
unit mm

// Legs of a pipe that overlap by a twentieth of its width.
region disc = region(circle((0, 0), 0.3, normal = (1, 0, 0)))
curve way = interpolate([(0, -1), (2, 0), (4, -1), (6, 0), (5, 2), (4, 1.5), (2, 0.59), (0, 1.5)])
print volume(sweep(disc, way, tolerance = 1e-3))

// A loop of the outline, 0.05 wide.
curve looped = interpolate([(1, 0, 0), (1, 0, 2), (1.02, 0, 2.02), (1.04, 0, 2), (1, 0, 1.99), (0.5, 0, 1.99), (0.5, 0, 3)])
print volume(solid(revolve(looped), cap = true))

// Walls that run back over themselves.
print volume(skin([for z in [0, 2, 1, 3]: region(circle((0, 0, z), 1))]))
print volume(solid(revolve(interpolate([(1, 0, 0), (1, 0, 2), (1, 0, 1), (1, 0, 3)])), cap = true))

// Rims that cross in one plane.
print volume(sweep(region(circle((0, 0), 1, normal = (1, 0, 0))), bezier((0, 0), (3, 0), (3, 1), (0, 1)), tolerance = 1e-2))

// Holes in another order.
fn bored(z, a, b) = region(circle((0, 0, z), 3), holes = [circle((a, 0, z), 0.5), circle((b, 0, z), 0.5)])
print volume(skin([bored(0, -1.5, 1.5), bored(4, 1.5, -1.5)]))
