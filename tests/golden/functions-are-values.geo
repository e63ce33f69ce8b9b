let square = x => x^2
let plane_wave = (u, v) => (u, v, sin(u * v))
fn twice(f) = x => f(f(x))
fn compose(f, g) = x => g(f(x))
check twice(square)(3) == 81
check compose(square, sqrt)(-5) == 5
check map([1, 4], sqrt) == [1, 2] "built-ins are values"
let c = line((0, 0), (2, 0))
check map([0, 0.5], c) == [(0, 0), (1, 0)] "curves too"
check plane_wave(0, 1) == (0, 1, 0)
let adders = [for k in 1..3: x => x + k]
check [for f in adders: f(10)] == [11, 12, 13] "each closure keeps its own variable"
print square, twice, sqrt
