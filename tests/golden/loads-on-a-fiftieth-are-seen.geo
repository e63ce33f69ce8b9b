// A load on a part of a curve or of the range of a trajectory, which adds up to one wherever it is.
fn load(start, width) = t => if start < t and t < start + width then 1/width else 0
let starts = [for k in 0..<12: 0.97 * k / 11]
fn along_curve(start, width) = integrate(p => load(start, width)(p.x), line((0, 0), (1, 0)))
check every([for s in starts: along_curve(s, 0.02)], f = sum => sum ~= 1 within 1e-9)
check every([for s in starts: along_curve(s, 0.03)], f = sum => sum ~= 1 within 1e-9)
fn followed(start, width) = ode((t, p) => (load(start, width)(t), 0), start = (0, 0), range = 0..1, tolerance = 1e-6).end.x
check every([for s in starts: followed(s, 0.011)], f = sum => sum ~= 1 within 1e-5)
check every([for s in starts: followed(s, 0.03)], f = sum => sum ~= 1 within 1e-5)
