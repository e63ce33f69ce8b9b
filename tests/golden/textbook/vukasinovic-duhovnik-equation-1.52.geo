// Vukašinović, Duhovnik: Gordon surface with Lagrange blending on a 3x3 network ((1.47)-(1.52) corrected Lagrange products)
geo 1
check [for i in 0..2: lagrange([for j in 0..2: (if i == j then 1 else 0, j)], parameters = [0, 1/3, 1])(1/5).x] ~= [8/25, 18/25, -1/25] within 1e-12
