// The NURBS Book: Bilinearly blended Coons patch as a NURBS surface ((10.34)-(10.36) corrected T = [1-u u][..][1-v v]^T)
geo 1
curve c0 = bezier((0, 0, 0), (1, 0, 2), (2, 0, 1), (4, 0, 0))
curve c1 = bezier((0, 3, 1), (2, 4, 0), (4, 3, 0))
curve d0 = bezier((0, 0, 0), (0, 1, 1), (0, 2, 3), (0, 3, 1))
curve d1 = bezier((4, 0, 0), (5, 1, 1), (4, 3, 0))
surface s = coons(u = [c0, c1], v = [d0, d1])
check [s.degree_u, s.degree_v] == [3, 3]
check s.points ~= [
  [(0, 0, 0), (0, 1, 1), (0, 2, 3), (0, 3, 1)],
  [(1, 0, 2), (4/3, 10/9, 19/9), (13/9, 7/3, 8/3), (4/3, 11/3, 1/3)],
  [(2, 0, 1), (8/3, 1, 4/3), (26/9, 20/9, 14/9), (8/3, 11/3, 0)],
  [(4, 0, 0), (14/3, 2/3, 2/3), (14/3, 5/3, 2/3), (4, 3, 0)],
] within 4.67e-12
check s(1/2, 1/2) ~= (33/16, 13/8, 3/2) within 2.06e-12
check derivative(s, 1/2, 1/2) ~= (35/8, -1/4, -3/2) within 4.37e-12
check derivative(s, 1/2, 1/2, du = 0, dv = 1) ~= (3/8, 7/2, -1/4) within 3.5e-12
check derivative(s, 1/2, 1/2, du = 2) ~= (3/2, -2, -7/2) within 3.5e-12
check twist(s, 1/2, 1/2) ~= (1/4, 0, -3/2) within 1.5e-12
check derivative(s, 1/2, 1/2, du = 0, dv = 2) ~= (-2, 1, -13/2) within 6.5e-12
check normal(s, 1/2, 1/2) ~= (0.32581760622553729, 0.032581760622553729, 0.94487105805405815) within 1e-12
check gaussian(s, 1/2, 1/2) ~= 0.066614373844142776 within 1e-12
check mean(s, 1/2, 1/2) ~= -0.33457683122881921 within 1e-12
check principal(s, 1/2, 1/2).k1 ~= -0.54747887948335103 within 1e-12
check principal(s, 1/2, 1/2).k2 ~= -0.12167478297428739 within 1e-12
check s(1/3, 3/4) ~= (299/216, 121/48, 419/288) within 2.52e-12
check derivative(s, 1/3, 3/4) ~= (101/24, 5/16, -93/64) within 4.21e-12
check derivative(s, 1/3, 3/4, du = 0, dv = 1) ~= (-1/27, 65/18, -55/24) within 3.61e-12
check derivative(s, 1/3, 3/4, du = 2) ~= (1/2, -3, -3/2) within 3e-12
check twist(s, 1/3, 3/4) ~= (-1/3, 7/6, -67/48) within 1.4e-12
check derivative(s, 1/3, 3/4, du = 0, dv = 2) ~= (-4/3, 2/3, -37/3) within 1.23e-11
check normal(s, 1/3, 3/4) ~= (0.24364544781817868, 0.52145726877867667, 0.81775253750469166) within 1e-12
check gaussian(s, 1/3, 3/4) ~= 0.076565602282570151 within 1e-12
check mean(s, 1/3, 3/4) ~= -0.3527085671003037 within 1e-12
check principal(s, 1/3, 3/4).k1 ~= -0.57142695001170713 within 1e-12
check principal(s, 1/3, 3/4).k2 ~= -0.13399018418890028 within 1e-12
check s(0.9, 0.2) ~= (4689/1250, 123/250, 1439/2500) within 3.75e-12
check derivative(s, 0.9, 0.2) ~= (683/125, -12/25, -316/125) within 5.46e-12
check derivative(s, 0.9, 0.2, du = 0, dv = 1) ~= (1251/1000, 66/25, 1053/1000) within 2.64e-12
check derivative(s, 0.9, 0.2, du = 2) ~= (108/25, -4/5, -26/25) within 4.32e-12
check twist(s, 0.9, 0.2) ~= (-23/100, -11/5, 131/100) within 2.2e-12
check derivative(s, 0.9, 0.2, du = 0, dv = 2) ~= (-18/5, 9/5, -18/5) within 3.6e-12
check normal(s, 0.9, 0.2) ~= (0.33291562771830043, -0.48120698885490312, 0.81092972488257399) within 1e-12
check gaussian(s, 0.9, 0.2) ~= -0.026398476231564324 within 1e-12
check mean(s, 0.9, 0.2) ~= -0.26831926395838283 within 1e-12
check principal(s, 0.9, 0.2).k1 ~= -0.58199697059806841 within 1e-12
check principal(s, 0.9, 0.2).k2 ~= 0.045358442681302743 within 1e-12
