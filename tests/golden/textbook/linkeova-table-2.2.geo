// Linkeová: Cubic Bernstein polynomials and derivatives at 0 and 1 (Table 2.2)
geo 1
check [for i in 0..3: bezier([for j in 0..3: (if i == j then 1 else 0, j)])(0).x] ~= [1, 0, 0, 0] within 1e-12
check [for i in 0..3: bezier([for j in 0..3: (if i == j then 1 else 0, j)])(1).x] ~= [0, 0, 0, 1] within 1e-12
check [for i in 0..3: derivative(bezier([for j in 0..3: (if i == j then 1 else 0, j)]), 0).x] ~= [-3, 3, 0, 0] within 3e-12
check [for i in 0..3: derivative(bezier([for j in 0..3: (if i == j then 1 else 0, j)]), 1).x] ~= [0, 0, -3, 3] within 3e-12
check [for i in 0..3: derivative(bezier([for j in 0..3: (if i == j then 1 else 0, j)]), 0, order = 2).x] ~= [6, -12, 6, 0] within 1.2e-11
check [for i in 0..3: derivative(bezier([for j in 0..3: (if i == j then 1 else 0, j)]), 1, order = 2).x] ~= [0, 6, -12, 6] within 1.2e-11
