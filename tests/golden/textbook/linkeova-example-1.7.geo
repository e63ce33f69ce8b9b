// Linkeová: Torus: classification of points, curvatures (sign towards Pu x Pv, i.e. inward) (Example 1.7 / Fig 1.14, Definitions 1.29-1.30)
geo 1
let major = 2
let minor = 1
surface s = parametric((u, v) => ((minor*cos(u)+major)*cos(v), (minor*cos(u)+major)*sin(v), minor*sin(u)+4), 0..2*pi, 0..2*pi)
check gaussian(s, 0, 0) ~= 0.33333333333333333 within 1e-12
check mean(s, 0, 0) ~= 0.66666666666666667 within 1e-12
check principal(s, 0, 0).k1 ~= 0.33333333333333333 within 1e-12
check principal(s, 0, 0).k2 ~= 1 within 1e-12
check classify(s, 0, 0) == "elliptic"
check gaussian(s, pi/4, 0) ~= 0.26120387496374144 within 1e-12
check mean(s, pi/4, 0) ~= 0.63060193748187072 within 1e-12
check principal(s, pi/4, 0).k1 ~= 0.26120387496374144 within 1e-12
check principal(s, pi/4, 0).k2 ~= 1 within 1e-12
check classify(s, pi/4, 0) == "elliptic"
check gaussian(s, pi/2, 0) ~= 0 within 1e-12
check mean(s, pi/2, 0) ~= 0.5 within 1e-12
check principal(s, pi/2, 0).k1 ~= 0 within 1e-12
check principal(s, pi/2, 0).k2 ~= 1 within 1e-12
check classify(s, pi/2, 0) == "parabolic"
check gaussian(s, 3*pi/2, 0) ~= 0 within 1e-12
check mean(s, 3*pi/2, 0) ~= 0.5 within 1e-12
check principal(s, 3*pi/2, 0).k1 ~= 0 within 1e-12
check principal(s, 3*pi/2, 0).k2 ~= 1 within 1e-12
check classify(s, 3*pi/2, 0) == "parabolic"
check gaussian(s, pi, 0) ~= -1 within 1e-12
check mean(s, pi, 0) ~= 0 within 1e-12
check principal(s, pi, 0).k1 ~= -1 within 1e-12
check principal(s, pi, 0).k2 ~= 1 within 1e-12
check classify(s, pi, 0) == "hyperbolic"
check gaussian(s, 3*pi/4, 0) ~= -0.54691816067802716 within 1e-12
check mean(s, 3*pi/4, 0) ~= 0.22654091966098642 within 1e-12
check principal(s, 3*pi/4, 0).k1 ~= -0.54691816067802716 within 1e-12
check principal(s, 3*pi/4, 0).k2 ~= 1 within 1e-12
check classify(s, 3*pi/4, 0) == "hyperbolic"
