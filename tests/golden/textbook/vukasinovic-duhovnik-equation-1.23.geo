// Vukašinović, Duhovnik: Bicubic Bezier surface ((1.23))
geo 1
let net = [
  [(0, 0, 0), (0, 1, 4), (0, 2, 3), (0, 3, 2)],
  [(1, 0, 1), (1, 1, 2), (1, 2, 3), (1, 3, 4)],
  [(2, 0, 4), (2, 1, 2), (2, 2, 0), (2, 3, 3)],
  [(3, 0, 4), (3, 1, 4), (3, 2, 4), (3, 3, 4)],
]
surface s = bezier(net)
check s(1/3, 3/4) ~= (1, 9/4, 2369/864) within 2.74e-12
check derivative(s, 1/3, 3/4) ~= (3, 0, -119/192) within 3e-12
check derivative(s, 1/3, 3/4, du = 0, dv = 1) ~= (0, 3, 91/72) within 3e-12
check derivative(s, 1/3, 3/4, du = 2) ~= (0, 0, -13/16) within 1e-12
check twist(s, 1/3, 3/4) ~= (0, 0, 83/16) within 5.19e-12
check derivative(s, 1/3, 3/4, du = 0, dv = 2) ~= (0, 0, 25/9) within 2.78e-12
check normal(s, 1/3, 3/4) ~= (0.1870310775198171, -0.38139670709923486, 0.90529328278499704) within 1e-12
check gaussian(s, 1/3, 3/4) ~= -0.24186077150247314 within 1e-12
check mean(s, 1/3, 3/4) ~= 0.11717083517508053 within 1e-12
check principal(s, 1/3, 3/4).k1 ~= -0.38838803985145783 within 1e-12
check principal(s, 1/3, 3/4).k2 ~= 0.62272971020161888 within 1e-12
