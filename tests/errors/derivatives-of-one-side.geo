// A jump stands on a corner of the curve.
print gradient(k => integrate(p => if p.x < k then 1 else 0, polyline((0, 0), (1, 0), (1, 1))), 1)
// The trajectory starts on a jump of its rate, or ends on one.
print gradient(k => ode((t, p) => (if p.x < k then 1 else 3, 0), start = (0.4, 0), range = 0..2).end.x, 0.4)
print gradient(k => ode((t, p) => (if t < k then 1 else 3, 0), start = (0, 0), range = 0..1).end.x, 1)
// Two places are equally near.
print gradient(k => closest(polyline((0, 1), (0, 0), (1, 0)), (k, 0.5)).distance, 0.5)
// Which of equal numbers is the least changes.
print gradient(x => [x, 1][argmin([x, 1])], 1)
