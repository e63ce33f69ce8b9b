// Poles and steps are no roots, and all roots are those beside them.
check solve(x => tan(x) - 1, within = 0..10, all = true) ~= [for k in 0..2: (k + 0.25)*pi] within 1e-12
check solve(x => 1/(x - 0.3) - 2, within = -1..1, all = true) ~= [0.8] within 1e-12
check solve(x => if x < 1 then -1 else 1, within = 0..2, all = true) == []
// Also where a place that is looked at is the pole itself, at which there is no value.
check solve(x => (x - 6.1229)/(x - 6.6196), within = 5.1132..7.2489, all = true) ~= [6.1229] within 1e-12
check solve(x => (x - 0.25)/(x - 1), within = 0..2) ~= 0.25 within 1e-12
check solve(x => (x - 0.25)/(x - 1)^2, within = 0..2, all = true) ~= [0.25] within 1e-12
