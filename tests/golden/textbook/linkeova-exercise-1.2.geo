// Linkeová: Torus R=2 r=1: curvature radii of parametric curves, min radius over all parametric curves (Exercise 1.2)
geo 1
let major = 2
let minor = 1
surface s = parametric((u, v) => ((minor*cos(u)+major)*cos(v), (minor*cos(u)+major)*sin(v), minor*sin(u)+4), 0..2*pi, 0..2*pi)
check radius_of_curvature(s(_, 0), 0) ~= 1 within 1e-12
check radius_of_curvature(s(0, _), 0) ~= 3 within 3e-12
check gaussian(s, 0, 0) ~= 0.33333333333333333 within 1e-12
check mean(s, 0, 0) ~= 0.66666666666666667 within 1e-12
check principal(s, 0, 0).k1 ~= 0.33333333333333333 within 1e-12
check principal(s, 0, 0).k2 ~= 1 within 1e-12
check classify(s, 0, 0) == "elliptic"
check radius_of_curvature(s(_, 0), pi/2) ~= 1 within 1e-12
check radius_of_curvature(s(pi/2, _), 0) ~= 2 within 2e-12
check gaussian(s, pi/2, 0) ~= 0 within 1e-12
check mean(s, pi/2, 0) ~= 0.5 within 1e-12
check principal(s, pi/2, 0).k1 ~= 0 within 1e-12
check principal(s, pi/2, 0).k2 ~= 1 within 1e-12
check classify(s, pi/2, 0) == "parabolic"
check radius_of_curvature(s(_, 0), pi) ~= 1 within 1e-12
check radius_of_curvature(s(pi, _), 0) ~= 1 within 1e-12
check gaussian(s, pi, 0) ~= -1 within 1e-12
check mean(s, pi, 0) ~= 0 within 1e-12
check principal(s, pi, 0).k1 ~= -1 within 1e-12
check principal(s, pi, 0).k2 ~= 1 within 1e-12
check classify(s, pi, 0) == "hyperbolic"
