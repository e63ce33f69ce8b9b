// Which parameters a fit used can be asked: the curve is near each point there.
geo 1

let places = [for i in 0..40: (i / 4, sin(i / 4 * 1rad))]
curve near = approximate(places, tolerance = 1e-3)
let used = report(near).parameters
check len(used) == len(places)
check used[0] == 0 and used[-1] == 1
check every(0..40, i => norm(near(used[i]) - places[i]) <= 1e-3)
