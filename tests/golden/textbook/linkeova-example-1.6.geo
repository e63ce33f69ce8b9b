// Linkeová: Torus: tangent, twist and normal vectors (normals point INWARD) (Example 1.6)
geo 1
let major = 2
let minor = 1
surface s = parametric((u, v) => ((minor*cos(u)+major)*cos(v), (minor*cos(u)+major)*sin(v), minor*sin(u)+4), 0..2*pi, 0..2*pi)
check derivative(s, pi/4, 3*pi/4) ~= (0.5, -0.5, 0.70710678118654752) within 1e-12
check derivative(s, pi/4, 3*pi/4, du = 0, dv = 1) ~= (-1.914213562373095, -1.914213562373095, 0) within 1.91e-12
check twist(s, pi/4, 3*pi/4) ~= (0.5, 0.5, 0) within 1e-12
check cross(derivative(s, pi/4, 3*pi/4), derivative(s, pi/4, 3*pi/4, du = 0, dv = 1)) ~= (1.3535533905932738, -1.3535533905932738, -1.914213562373095) within 1.91e-12
check derivative(s, 0, 0) ~= (0, 0, 1) within 1e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 0) within 1e-12
check cross(derivative(s, 0, 0), derivative(s, 0, 0, du = 0, dv = 1)) ~= (-3, 0, 0) within 3e-12
check derivative(s, pi/2, pi/3) ~= (-0.5, -0.86602540378443865, 0) within 1e-12
check derivative(s, pi/2, pi/3, du = 0, dv = 1) ~= (-1.7320508075688773, 1, 0) within 1.73e-12
check twist(s, pi/2, pi/3) ~= (0.86602540378443865, -0.5, 0) within 1e-12
check cross(derivative(s, pi/2, pi/3), derivative(s, pi/2, pi/3, du = 0, dv = 1)) ~= (0, 0, -2) within 2e-12
check derivative(s, pi, pi/6) ~= (0, 0, -1) within 1e-12
check derivative(s, pi, pi/6, du = 0, dv = 1) ~= (-0.5, 0.86602540378443865, 0) within 1e-12
check twist(s, pi, pi/6) ~= (0, 0, 0) within 1e-12
check cross(derivative(s, pi, pi/6), derivative(s, pi, pi/6, du = 0, dv = 1)) ~= (0.86602540378443865, 0.5, 0) within 1e-12
