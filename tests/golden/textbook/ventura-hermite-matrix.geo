// Ventura: the matrix of the cubic from end points and tangents, highest power first (p.5-6 [H])
geo 1
let ones = [for i in 0..3: [for j in 0..3: if i == j then (1, 0) else (0, 0)]]
fn column(e) = [for c in reverse(power_coefficients(hermite([e[0], e[1]], [e[2], e[3]]))): c.x]
check transpose([for e in ones: column(e)]) ~= [[2, -2, 1, 1], [-3, 3, -2, -1], [0, 0, 1, 0], [1, 0, 0, 0]] within 3e-12
