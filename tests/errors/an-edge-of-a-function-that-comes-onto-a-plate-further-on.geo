// An edge that hovers over a plate in its first dip, and comes onto it in the second, within what a spline misses.
geo 1
unit m
let plate = plane_patch((-3, -3), (6, 0), (0, 6))
fn t(v) = (v - 0.25) / 0.515
fn height(v) = 2e-5 * t(v)^2 * (1 - t(v))^2 + 5e-7 + (5e-9 - 5e-7) * (3 * t(v)^2 - 2 * t(v)^3)
print intersect(parametric((u, v) => (u * 1m, v * 1m, height(v) * 1m + 0.1m * u), 0..1, 0..1), plate)
