// Linkeová: Second Coons cubic of the overlapping polygon, C2 join (Exercise 2.18, Fig 2.21)
geo 1
curve c = coons_bspline([(-6, 0), (6, 0), (6, 6), (0, 6), (-3, 3)])
let pieces = decompose(c)
curve power_form_1 = polynomial([(5, 5), (-3, 3), (-3, -3), (3/2, 1/2)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 5e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 5e-12
check c(1) ~= (5, 5, 0) within 5e-12
check derivative(c, 1) ~= (-3, 3, 0) within 3e-12
check derivative(trim(c, 0..1), 1, order = 2) ~= (-6, -6, 0) within 6e-12
check derivative(trim(c, 1..2), 1, order = 2) ~= (-6, -6, 0) within 6e-12
check derivative(trim(c, 0..1), 1, order = 3) ~= (6, -12, 0) within 1.2e-11
check derivative(trim(c, 1..2), 1, order = 3) ~= (9, 3, 0) within 9e-12
check continuity(pieces[0], pieces[1]).c == 2
check [for piece in decompose(c): piece.points] ~= [[(4, 1, 0), (6, 2, 0), (6, 4, 0), (5, 5, 0)], [(5, 5, 0), (4, 6, 0), (2, 6, 0), (1/2, 11/2, 0)]] within 6e-12
