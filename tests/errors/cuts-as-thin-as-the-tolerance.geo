geo 1

// The plane cuts off a sliver of two tolerances from the base of the half ball.
let half = cut(solid(sphere((0, 0, 0), 1)), XY, keep = "above")
let beside = plane((1, 0, 0) - 1e-6 * (1, 0, 1), (1, 0, 1))
print volume(cut(half, rotate(beside, 33deg)))
