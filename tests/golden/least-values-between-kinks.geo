// Polynomials through 21 places by the least sum of magnitudes and by the least greatest one, whose values linear
// programming tells: valleys of kinks that are a thousand times as long as wide.
let places = [for k in 0..20: k]
fn power(v, k) = sum([for p in 0..<len(v): v[p] * k^p])
fn rests(v, y) = [for k in places: abs(power(v, k) - y(k))]
fn searched(f, n) = minimize(f, start = [for p in 0..<n: 0], report = true)

let exact = searched(v => sum(rests(v, k => 2 + 3*k - k^2)), 4)
check exact.value < 1e-9
fn bent(k) = 2 + 3*k + sin(k * 1rad)
check searched(v => sum(rests(v, bent)), 2).value ~= 13.004205068312 within 1e-9
check searched(v => sum(rests(v, bent)), 3).value ~= 12.560377459493 within 1e-9
check searched(v => sum(rests(v, bent)), 4).value ~= 12.492884099391 within 1e-9
check searched(v => max(rests(v, bent)), 2).value ~= 0.994986503855 within 1e-9
check searched(v => max(rests(v, bent)), 3).value ~= 0.990318553155 within 1e-9
check searched(v => max(rests(v, bent)), 4).value ~= 0.990007838445 within 1e-9

// The same within bounds, and the greatest of what is below zero.
let held = minimize(v => sum(rests(v, bent)), start = [0, 0, 0], within = -100..100, report = true)
check held.value ~= 12.560377459493 within 1e-9
check maximize(v => -max(rests(v, bent)), start = [1, 1, 1], report = true).value ~= -0.990318553155 within 1e-9

// From the bottom of one valley, where no way down leads off the kink.
fn crossed(v) = 30*abs(v[0] + v[1] - 1) + abs(v[0] - 2*v[1] - 4)
check minimize(crossed, start = [5, -4]) ~= [2, -1] within 1e-7
fn nesterov(v) = (v[0] - 1)^2 / 4 + abs(v[1] - 2*v[0]^2 + 1)
check minimize(nesterov, start = [-1, 1], report = true).value ~= 0 within 1e-9
let inside = minimize(v => -v[0] + 20*max(v[0]^2 + v[1]^2 - 1, 0), start = [0.8, 0.6])
check inside ~= [1, 0] within 1e-6

// Where three of four smooth functions meet: the circle around a triangle is the least around its corners.
let corners = [(0, 0), (4, 0), (1, 3), (2, 1)]
let around = minimize(p => max([for c in corners: norm(p - c)]), start = (9, -7), report = true)
check around.at ~= (2, 1) within 1e-7
check around.value ~= sqrt(5) within 1e-9
print "{exact.value < 1e-9}: {around.value:.9}"
