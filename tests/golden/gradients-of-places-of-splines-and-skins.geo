// Places of what is made of many numbers, by each of them: against differences, and closed forms.
let n = 11
let heights = [for i in 0..n: 0.4 * sin(0.9rad * i)]
fn through(u) = [for i in 0..n: (i + 0.1 * u[(i + 3) % n], u[i], 0.2 * i * u[i])]
fn are_like(f) = {
  let [exact, beside] = [gradient(f, heights), gradient(f, heights, differences = true)]
  every(0..n, f = i => abs(exact[i] - beside[i]) < 1e-6)
}

// Splines by each rule and with each end, open and closed; a place, a direction, a curvature and the length.
fn asked(c) = dot(c(0.37), (1, 2, -1)) + curvature(c, 0.62) * 1mm + dot(tangent(c, 0.15), (0, 1, 1)) + length(c) / 1mm
let rules = ["chord", "centripetal", "uniform"]
let ends = ["bessel", "natural", "quadratic", "not-a-knot", "averaged"]
check every(rules, f = rule => every(ends, f = end => are_like(u => asked(interpolate(through(u), parameters = rule, ends = end)))))
check every([2, 4, 5], f = p => are_like(u => asked(interpolate(through(u), degree = p))))
check are_like(u => asked(interpolate(through(u), closed = true)))
// What is made of such a spline in turn.
check are_like(u => asked(translate(interpolate(through(u), parameters = "uniform"), (u[2], 0, u[5]))))

// Skins of sections that have as many control points, of which each row is made of its own.
let many = [for k in 0..49: 0.3 * sin(1.3rad * k)]
fn rib(u, i) = bspline([for j in 0..9: (5 * i, 2 + 0.2 * u[10 * i + j], j)])
fn hull(u) = skin([for i in 0..4: rib(u, i)], parameters = [0, 0.2, 0.5, 0.7, 1])
let by_many = gradient(u => dot(hull(u)(0.31, 0.52), (1, 2, 3)), many)
fn changed(k, h) = [for m in 0..49: many[m] + (if m == k then h else 0)]
fn slope(k) = (dot(hull(changed(k, 1e-3))(0.31, 0.52), (1, 2, 3)) - dot(hull(changed(k, -1e-3))(0.31, 0.52), (1, 2, 3))) / 2e-3
check every([for k in 0..9: 5 * k + k % 5], f = k => abs(by_many[k] - slope(k)) < 1e-9)
// Lines that change their places have theirs too.
fn mast(u) = bspline([for k in 0..49: (k, u[k])])
check every(0..49, f = k => gradient(u => reversed(mast(u))(0.3).y, many)[k] ~= gradient(u => mast(u)(0.7).y, many)[k] within 1e-12)
// A long step would turn the rings around.
fn horn(a) = skin([for z in 0..3: circle((0, 0, 2 * z), 1 + 0.025 * a * z^2)], parameters = [0, 0.3, 0.6, 1])
check gradient(a => norm(horn(a)(0.3, 1)), 4) ~= 0.225 * 1.9 / norm((1.9, 6)) within 1e-9
