param beam = 3 in 1..6
param length = 10
let waterplane = 2 / 3 * beam * length
fn half(x) = beam / 2 * (1 - (x / length)^2)
curve keel = line((0, 0), (length, 0))
let _private = beam
check beam > 100 "does not run"
print "does not run either"
