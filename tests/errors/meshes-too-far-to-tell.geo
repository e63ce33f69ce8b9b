geo 1

// So far from the origin coordinates are 0.125 apart.
let far = translate(sphere((0, 0, 0), 1), (1e15, 0, 0))
mesh of_far = tessellate(far)
