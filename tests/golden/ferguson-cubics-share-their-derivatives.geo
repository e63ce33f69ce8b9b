// Linkeova, Examples 2.1 and 2.2: the longer part of the "@" sign.
let through = [(47, 46), (58, 20), (64, 35), (55, 56), (26, 61), (9, 28), (47, 7)]
let tangents = [(3, -78), (12, 6), (0, 21), (-21, 18), (-30, -15), (3, -42), (81, 21)]
curve k = ferguson(through, tangents)
check k.domain == 0..6
check [for i in 0..6: k(i)] ~= through within 1e-12
check [for i in 0..6: derivative(k, i)] ~= tangents within 1e-12
check k(1/2) ~= (411/8, 45/2) within 1e-12
check derivative(k, 3/2) ~= (6, 63/4) within 1e-12
check derivative(k, 11/2) ~= (36, -105/4) within 1e-12

// A tangent of length zero makes a straight segment that starts slowly.
curve slow = hermite([(0, 0), (2, 4)], [(0, 0), (0, 0)])
check slow(1/2) ~= (1, 2) within 1e-15
check derivative(slow, 0) ~= (0, 0) within 1e-15
