// A jump stands on an end of the range, and moves apart from it.
print gradient(k => integrate(x => if x < k then 5 else 1, 0..1), 0)
print gradient(k => integrate(t => if t < 0.5 then 1 else 3, 0..k), 0.5)
print gradient(k => integrate(p => if p.x < k then 1 else 0, polyline((0, 0), (1, 0), (1, 1))), 1)
// The trajectory starts on a jump of its rate, or ends on one.
print gradient(k => ode((t, p) => (if p.x < k then 1 else 3, 0), start = (0.4, 0), range = 0..2).end.x, 0.4)
print gradient(k => ode((t, p) => (if t < k then 1 else 3, 0), start = (0, 0), range = 0..1).end.x, 1)
// Two places are equally near, or the nearest one begins to stay at an end.
print gradient(k => closest(polyline((0, 1), (0, 0), (1, 0)), (k, 0.5)).distance, 0.5)
print gradient(k => closest(line((0, 0), (1, 0)), (k, 1)).t, 1)
// Equal numbers change their order.
print gradient(x => sort([x, 1])[0], 1)
print gradient(x => [x, 1][argmin([x, 1])], 1)
