// Poles and steps are no roots, and all roots are those beside them.
check solve(x => tan(x) - 1, within = 0..10, all = true) ~= [for k in 0..2: (k + 0.25)*pi] within 1e-12
check solve(x => 1/(x - 0.3) - 2, within = -1..1, all = true) ~= [0.8] within 1e-12
check solve(x => if x < 1 then -1 else 1, within = 0..2, all = true) == []
