// The coefficients of powers add up to the surface; the normal line runs along the normal.
geo 1

surface s = bezier([[(0, 0), (0, 1, 1)], [(1, 0), (1, 1)], [(2, 0, 1), (2, 1, 1)]])
let powers = power_coefficients(s)
print powers
let [u, v] = [0.3, 0.7]
check powers[0][0] + powers[0][1] * v + u * (powers[1][0] + powers[1][1] * v) + u^2 * (powers[2][0] + powers[2][1] * v) ~= s(u, v) within 1e-14

curve n = normal_line(s, u, v)
check n.start ~= s(u, v)
check cross(n.end - n.start, normal(s, u, v)) ~= (0, 0) within 1e-14
