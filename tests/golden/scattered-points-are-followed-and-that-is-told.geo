// Points without a course: no curve of few control points comes near to all of them.
let xs = random(60, seed = 1)
let ys = random(60, seed = 2)
points scattered = [for i in 0..<60: (xs[i], ys[i])]
let way = sum([for i in 0..<59: distance(scattered[i], scattered[i + 1])])
curve followed = approximate(scattered, tolerance = 0.01)
check length(followed) < 1.25 * way
check max([for p in scattered: closest(followed, p).distance]) <= 0.01
