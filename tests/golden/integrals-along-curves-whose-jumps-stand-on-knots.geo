// The circle has knots at its quarters and its seam at (1, 0). A line that cuts it at p.x = r cuts arcs of the speed
// 1/sqrt(1 - r^2) on both sides.
curve ring = circle((0, 0), 1)
check gradient(r => integrate(p => if p.x < r then 1 else 0, ring), 0) ~= 2mm within 1e-9
check gradient(r => integrate(p => if p.y < r then 1 else 0, ring), 0) ~= 2mm within 1e-9
check gradient(r => integrate(p => if p.x < r then 1 else 0, ring), 0.6) ~= 2.5mm within 1e-9
check gradient(r => integrate(p => if p.y < r then 1 else 0, ring), -0.6) ~= 2.5mm within 1e-9
// Straight on over an inner knot.
check gradient(r => integrate(p => if p.x < r then 1 else 0, polyline((0, 0), (1, 0), (3, 0))), 1) ~= 1mm within 1e-9
