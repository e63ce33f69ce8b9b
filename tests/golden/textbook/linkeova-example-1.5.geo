// Linkeová: Torus vector equation R=2 r=1, centre height 4 (Example 1.5)
geo 1
let major = 2
let minor = 1
surface s = parametric((u, v) => ((minor*cos(u)+major)*cos(v), (minor*cos(u)+major)*sin(v), minor*sin(u)+4), 0..2*pi, 0..2*pi)
check s(pi/4, 3*pi/4) ~= (-1.914213562373095, 1.914213562373095, 4.7071067811865475) within 4.71e-12
check s(0, 0) ~= (3, 0, 4) within 4e-12
check s(pi, 0) ~= (1, 0, 4) within 4e-12
check s(pi/2, pi/3) ~= (1, 1.7320508075688773, 5) within 5e-12
