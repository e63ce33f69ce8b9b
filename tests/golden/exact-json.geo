unit cm
curve c = nurbs([(0, 0), (1, 0.1), (1, 1)], weights = [1, 0.5, 1], degree = 2)
let third = 1/3
export c, third, [1, (0, 1, 2), { ok: true, none: none }], "te\"xt" to "exact.json"
