// Hsu, Curve representation, (25): nodes 0, 1/3, 2/3, 1.
curve c = lagrange([(0, 0, 0), (1, 3, 1), (4, 2, 2), (5, 0, -1)])
check [for t in [0, 1/3, 2/3, 1]: c(t)] ~= [(0, 0, 0), (1, 3, 1), (4, 2, 2), (5, 0, -1)] within 1e-14
check c(1/9) ~= (-11/81, 44/27, 7/81) within 1e-14
check c(7/9) ~= (385/81, 35/27, 133/81) within 1e-14
check c.degree == 3 and c.segments == 1
// Vukašinović & Duhovnik (1.52): nodes 0, 1/3, 1.
let basis = [for i in 0..2: lagrange([for j in 0..2: (if i == j then 1 else 0, j)], parameters = [0, 1/3, 1])]
check [for l in basis: l(1/5).x] ~= [8/25, 18/25, -1/25] within 1e-15
