// A hundred turns: far more knots than a first guess has, and far fewer than there are points.
let wave = [for i in 0..<10_000: (i * 0.01, sin(i * 0.01), cos(i * 0.02))]
curve spline = approximate(wave, tolerance = 1e-3)
// With x as its parameter a cubic spline takes spans of (384/16 · 1e-3)^(1/4) = 0.394 for
// cos(2t): 254 of 100, which have 257 control points. Of the data only lengths are known.
check len(spline.points) <= 257
check report(spline).deviation.max <= 1e-3
