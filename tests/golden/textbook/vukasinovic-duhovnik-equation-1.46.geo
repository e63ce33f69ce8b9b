// Vukašinović, Duhovnik: Coons patch with linear and with cubic blending functions ((1.44)-(1.46), Fig 1.27-1.28)
geo 1
curve c0 = bezier((0, 0, 0), (1, 0, 1), (2, 0, 0))
curve c1 = bezier((0, 2, 0), (1, 2, -1), (2, 2, 1))
curve d0 = bezier((0, 0, 0), (0, 1, 2), (0, 2, 0))
curve d1 = bezier((2, 0, 0), (3, 1, 1), (2, 2, 1))
surface linear_blend = coons(u = [c0, c1], v = [d0, d1])
check linear_blend(1/2, 1/2) ~= (5/4, 1, 3/4) within 1.25e-12
check linear_blend(1/4, 2/3) ~= (11/18, 4/3, 23/36) within 1.33e-12
check linear_blend(1/3, 0) ~= (2/3, 0, 4/9) within 1e-12
check linear_blend(1, 3/4) ~= (19/8, 3/2, 15/16) within 2.37e-12
surface cubic_blend = coons(u = [c0, c1], v = [d0, d1], blend = "cubic")
check cubic_blend(1/2, 1/2) ~= (5/4, 1, 3/4) within 1.25e-12
check cubic_blend(1/4, 2/3) ~= (41/72, 4/3, 23/36) within 1.33e-12
check cubic_blend(1/3, 0) ~= (2/3, 0, 4/9) within 1e-12
check cubic_blend(1, 3/4) ~= (19/8, 3/2, 15/16) within 2.37e-12
