// Vukašinović, Duhovnik: Adjacent Coons patches: linear blending C0, cubic blending C1 across the common curve when the transversal boundaries join C1 (Fig 1.28)
geo 1
curve ac0 = bezier((0, 0, 0), (1, 0, 1), (2, 0, 0))
curve ac1 = bezier((0, 2, 0), (1, 2, -1), (2, 2, 1))
curve ad0 = bezier((0, 0, 0), (0, 1, 2), (0, 2, 0))
curve ad1 = bezier((2, 0, 0), (3, 1, 1), (2, 2, 1))
surface a_linear = coons(u = [ac0, ac1], v = [ad0, ad1])
surface a_cubic = coons(u = [ac0, ac1], v = [ad0, ad1], blend = "cubic")
curve bc0 = bezier((0, 2, 0), (1, 2, -1), (2, 2, 1))
curve bc1 = bezier((0, 4, 1), (1, 5, 2), (2, 4, 0))
curve bd0 = bezier((0, 2, 0), (0, 3, -2), (0, 4, 1))
curve bd1 = bezier((2, 2, 1), (1, 3, 1), (2, 4, 0))
surface b_linear = coons(u = [bc0, bc1], v = [bd0, bd1])
surface b_cubic = coons(u = [bc0, bc1], v = [bd0, bd1], blend = "cubic")
check derivative(a_linear, 1/3, 1, du = 0, dv = 1) ~= (-0.66666666666666667, 2, -3.7777777777777778) within 1e-12
check derivative(b_linear, 1/3, 0, du = 0, dv = 1) ~= (-0.66666666666666667, 2.4444444444444444, -1.3333333333333333) within 1e-12
check continuity(a_linear, b_linear, "v1", "v0").c == 0
check derivative(a_cubic, 1/3, 1, du = 0, dv = 1) ~= (-0.51851851851851852, 2, -2.962962962962963) within 1e-12
check derivative(b_cubic, 1/3, 0, du = 0, dv = 1) ~= (-0.51851851851851852, 2, -2.962962962962963) within 1e-12
check continuity(a_cubic, b_cubic, "v1", "v0").c >= 1
