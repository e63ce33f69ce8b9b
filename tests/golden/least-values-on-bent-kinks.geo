// A kink along a parabola, from places on it: no step off the kink leads lower, and straight ones along it are short.
fn folded(v, weight) = weight*abs(v[1] - v[0]^2) + (1 - v[0])^2
fn least(weight, start) = minimize(v => folded(v, weight), start = start, report = true).value
check least(10, [2, 4]) < 1e-6
check least(10, [-1, 1]) < 1e-6

// A kink that is a saddle along itself.
fn saddle(v) = 10*abs(v[1] - v[0]^2) - v[0]^2 + v[0]^4
check minimize(saddle, start = [0, 1], report = true).value ~= -1/4 within 1e-6

// Conditions that bind at kinks, and conditions with kinks of their own.
fn off(v) = abs(v[0] - 2) + abs(v[1] - 2)
check minimize(off, start = [0, 0], subject = v => v[0]^2 + v[1]^2 <= 1, report = true).value ~= 4 - sqrt(2) within 1e-7
fn inside(v) = abs(v[0]) + abs(v[1]) <= 1
check minimize(v => -3*v[0] - v[1], start = [-1, 3], subject = inside) ~= [1, 0] within 1e-7
check minimize(v => (v[0] - 2)^2 + (v[1] - 1)^2, start = [-1, 3], subject = inside) ~= [1, 0] within 1e-7

// Of values alone: no derivatives pass through a section. Circles on a ball, as near to a length and a height as is.
fn around(v) = sum([for c in section(sphere((0, 0, 0), 2 + v[0]^2), plane((0, 0, v[1]), (0, 0, 1))): length(c)])
let alone = minimize(v => abs(around(v) - 20) + abs(v[1] - 1), start = [0.5, 0.5], report = true)
check alone.value < 1e-6
print "{alone.value < 1e-6}, by {alone.derivatives}"
