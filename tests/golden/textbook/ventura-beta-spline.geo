// Ventura: Uniformly shaped beta-spline (p.12-13)
geo 1
let ctrl = [(0, 0), (1, 2), (3, 2), (4, 0), (6, 1)]
curve c0 = beta_spline(ctrl, bias = 1, tension = 0)
curve piece0_0 = trim(c0, 0..1)
curve piece0_1 = trim(c0, 1..2)
check piece0_0(0) ~= (7/6, 5/3, 0) within 1.67e-12
check derivative(piece0_0, 0) ~= (3/2, 1, 0) within 1.5e-12
check piece0_0(1/3) ~= (277/162, 17/9, 0) within 1.89e-12
check derivative(piece0_0, 1/3) ~= (31/18, 1/3, 0) within 1.72e-12
check piece0_0(1) ~= (17/6, 5/3, 0) within 2.83e-12
check derivative(piece0_0, 1) ~= (3/2, -1, 0) within 1.5e-12
check piece0_1(1) ~= (17/6, 5/3, 0) within 2.83e-12
check derivative(piece0_1, 1) ~= (3/2, -1, 0) within 1.5e-12
check piece0_1(4/3) ~= (533/162, 203/162, 0) within 3.29e-12
check derivative(piece0_1, 4/3) ~= (23/18, -25/18, 0) within 1.39e-12
check piece0_1(2) ~= (25/6, 1/2, 0) within 4.17e-12
check derivative(piece0_1, 2) ~= (3/2, -1/2, 0) within 1.5e-12
check continuity(piece0_0, piece0_1).c >= 2
check continuity(piece0_0, piece0_1).g >= 2
curve c1 = beta_spline(ctrl, bias = 2, tension = 0)
curve piece1_0 = trim(c1, 0..1)
curve piece1_1 = trim(c1, 1..2)
check piece1_0(0) ~= (5/7, 26/21, 0) within 1.24e-12
check derivative(piece1_0, 0) ~= (12/7, 16/7, 0) within 2.29e-12
check piece1_0(1/3) ~= (242/189, 1004/567, 0) within 1.77e-12
check derivative(piece1_0, 1/3) ~= (5/3, 62/63, 0) within 1.67e-12
check piece1_0(1) ~= (16/7, 40/21, 0) within 2.29e-12
check derivative(piece1_0, 1) ~= (9/7, -2/7, 0) within 1.29e-12
check piece1_1(1) ~= (16/7, 40/21, 0) within 2.29e-12
check derivative(piece1_1, 1) ~= (18/7, -4/7, 0) within 2.57e-12
check piece1_1(4/3) ~= (562/189, 913/567, 0) within 2.97e-12
check derivative(piece1_1, 4/3) ~= (34/21, -71/63, 0) within 1.62e-12
check piece1_1(2) ~= (26/7, 17/21, 0) within 3.71e-12
check derivative(piece1_1, 2) ~= (6/7, -1, 0) within 1e-12
check continuity(piece1_0, piece1_1).c == 0
check continuity(piece1_0, piece1_1).g >= 2
curve c2 = beta_spline(ctrl, bias = 1, tension = 5)
curve piece2_0 = trim(c2, 0..1)
curve piece2_1 = trim(c2, 1..2)
check piece2_0(0) ~= (19/17, 30/17, 0) within 1.76e-12
check derivative(piece2_0, 0) ~= (18/17, 12/17, 0) within 1.06e-12
check piece2_0(1/3) ~= (253/153, 98/51, 0) within 1.92e-12
check derivative(piece2_0, 1/3) ~= (2, 4/17, 0) within 2e-12
check piece2_0(1) ~= (49/17, 30/17, 0) within 2.88e-12
check derivative(piece2_0, 1) ~= (18/17, -12/17, 0) within 1.06e-12
check piece2_1(1) ~= (49/17, 30/17, 0) within 2.88e-12
check derivative(piece2_1, 1) ~= (18/17, -12/17, 0) within 1.06e-12
check piece2_1(4/3) ~= (502/153, 202/153, 0) within 3.28e-12
check derivative(piece2_1, 4/3) ~= (22/17, -30/17, 0) within 1.76e-12
check piece2_1(2) ~= (70/17, 6/17, 0) within 4.12e-12
check derivative(piece2_1, 2) ~= (18/17, -6/17, 0) within 1.06e-12
check continuity(piece2_0, piece2_1).c == 1
check continuity(piece2_0, piece2_1).g >= 2
curve c3 = beta_spline(ctrl, bias = 1/2, tension = 3)
curve piece3_0 = trim(c3, 0..1)
curve piece3_1 = trim(c3, 1..2)
check piece3_0(0) ~= (16/11, 64/33, 0) within 1.94e-12
check derivative(piece3_0, 0) ~= (9/11, 2/11, 0) within 1e-12
check piece3_0(1/3) ~= (577/297, 1750/891, 0) within 1.96e-12
check derivative(piece3_0, 1/3) ~= (64/33, -8/99, 0) within 1.94e-12
check piece3_0(1) ~= (35/11, 50/33, 0) within 3.18e-12
check derivative(piece3_0, 1) ~= (12/11, -16/11, 0) within 1.45e-12
check piece3_1(1) ~= (35/11, 50/33, 0) within 3.18e-12
check derivative(piece3_1, 1) ~= (6/11, -8/11, 0) within 1e-12
check piece3_1(4/3) ~= (1031/297, 950/891, 0) within 3.47e-12
check derivative(piece3_1, 4/3) ~= (38/33, -172/99, 0) within 1.74e-12
check piece3_1(2) ~= (49/11, 10/33, 0) within 4.45e-12
check derivative(piece3_1, 2) ~= (18/11, 4/11, 0) within 1.64e-12
check continuity(piece3_0, piece3_1).c == 0
check continuity(piece3_0, piece3_1).g >= 2
