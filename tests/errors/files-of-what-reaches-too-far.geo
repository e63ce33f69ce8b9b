geo 1

// So far from the origin coordinates are 0.125 apart.
export translate(sphere((0, 0, 0), 1), (1e15, 0, 0)) to "far.stl"
export translate(circle((0, 0), 1), (0, 1e15, 0)) to "far.obj"

// Squares of such lengths are no numbers.
let huge = scale(circle((0, 0), 1), 1e200)
export huge to "huge.obj"
export huge to "huge.svg"
