// Ventura: First/second fundamental forms, K and H (sign of the printed H formula corrected) (p.38)
geo 1
let net = [
  [(-1, -1, 0), (-1, 0, -1), (-1, 1, 0)], [(0, -1, 1), (0, 0, 0), (0, 1, 1)],
  [(1, -1, 0), (1, 0, -1), (1, 1, 0)],
]
surface s = bezier(net)
check s(1/2, 1/2) ~= (0, 0, 0) within 1e-12
check derivative(s, 1/2, 1/2) ~= (2, 0, 0) within 2e-12
check derivative(s, 1/2, 1/2, du = 0, dv = 1) ~= (0, 2, 0) within 2e-12
check derivative(s, 1/2, 1/2, du = 2) ~= (0, 0, -4) within 4e-12
check twist(s, 1/2, 1/2) ~= (0, 0, 0) within 1e-12
check derivative(s, 1/2, 1/2, du = 0, dv = 2) ~= (0, 0, 4) within 4e-12
check normal(s, 1/2, 1/2) ~= (0, 0, 1) within 1e-12
check gaussian(s, 1/2, 1/2) ~= -1 within 1e-12
check mean(s, 1/2, 1/2) ~= 0 within 1e-12
check principal(s, 1/2, 1/2).k1 ~= -1 within 1e-12
check principal(s, 1/2, 1/2).k2 ~= 1 within 1e-12
check dot(derivative(s, 1/2, 1/2), derivative(s, 1/2, 1/2)) ~= 4 within 4e-12
check dot(derivative(s, 1/2, 1/2), derivative(s, 1/2, 1/2, du = 0, dv = 1)) ~= 0 within 1e-12
check dot(derivative(s, 1/2, 1/2, du = 0, dv = 1), derivative(s, 1/2, 1/2, du = 0, dv = 1)) ~= 4 within 4e-12
check dot(normal(s, 1/2, 1/2), derivative(s, 1/2, 1/2, du = 2)) ~= -4 within 4e-12
check dot(normal(s, 1/2, 1/2), twist(s, 1/2, 1/2)) ~= 0 within 1e-12
check dot(normal(s, 1/2, 1/2), derivative(s, 1/2, 1/2, du = 0, dv = 2)) ~= 4 within 4e-12
check s(1/4, 2/3) ~= (-1/2, 1/3, -5/72) within 1e-12
check derivative(s, 1/4, 2/3) ~= (2, 0, 1) within 2e-12
check derivative(s, 1/4, 2/3, du = 0, dv = 1) ~= (0, 2, 2/3) within 2e-12
check derivative(s, 1/4, 2/3, du = 2) ~= (0, 0, -4) within 4e-12
check twist(s, 1/4, 2/3) ~= (0, 0, 0) within 1e-12
check derivative(s, 1/4, 2/3, du = 0, dv = 2) ~= (0, 0, 4) within 4e-12
check normal(s, 1/4, 2/3) ~= (-3/7, -2/7, 6/7) within 1e-12
check gaussian(s, 1/4, 2/3) ~= -1296/2401 within 1e-12
check mean(s, 1/4, 2/3) ~= 15/343 within 1e-12
check principal(s, 1/4, 2/3).k1 ~= -0.69226248932051638 within 1e-12
check principal(s, 1/4, 2/3).k2 ~= 0.77972604617182833 within 1e-12
check dot(derivative(s, 1/4, 2/3), derivative(s, 1/4, 2/3)) ~= 5 within 5e-12
check dot(derivative(s, 1/4, 2/3), derivative(s, 1/4, 2/3, du = 0, dv = 1)) ~= 2/3 within 1e-12
check dot(derivative(s, 1/4, 2/3, du = 0, dv = 1), derivative(s, 1/4, 2/3, du = 0, dv = 1)) ~= 40/9 within 4.44e-12
check dot(normal(s, 1/4, 2/3), derivative(s, 1/4, 2/3, du = 2)) ~= -24/7 within 3.43e-12
check dot(normal(s, 1/4, 2/3), twist(s, 1/4, 2/3)) ~= 0 within 1e-12
check dot(normal(s, 1/4, 2/3), derivative(s, 1/4, 2/3, du = 0, dv = 2)) ~= 24/7 within 3.43e-12
