check solve(x => cbrt(x^2 - 2), within = 0..2) ~= sqrt(2) within 1e-12
check solve(x => cbrt(x^2 - 2), within = 0..2, all = true) ~= [sqrt(2)] within 1e-12
check solve(x => cbrt(x^2 - 2), within = -2..2, all = true) ~= [-sqrt(2), sqrt(2)] within 1e-12
check solve(x => sign(x^2 - 2) * abs(x^2 - 2)^0.2, within = 0..3) ~= sqrt(2) within 1e-12
check solve(x => sign(x^2 - 2) * abs(x^2 - 2)^0.2, within = 0..3, all = true) ~= [sqrt(2)] within 1e-12
check solve(x => sign(x - 0.3) * abs(x - 0.3)^0.1, within = 0..1, all = true) ~= [0.3] within 1e-12
check solve(x => cbrt(x), within = -1..2, all = true) ~= [0] within 1e-12
