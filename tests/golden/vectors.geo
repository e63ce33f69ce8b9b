let a = (1, 2, 2)
let b = (2, 0, 0)
check norm(a) == 3 and dot(a, b) == 2
check cross((1, 0), (0, 1)) == (0, 0, 1)
check unit_vector(b) == (1, 0)
check distance((1, 1), (4, 5)) == 5
check midpoint((0, 0), (2, 4)) == (1, 2)
check angle_between((1, 0), (1, 1)) ~= 45deg
check a + b == (3, 2, 2) and a - b == (-1, 2, 2) and -a == (-1, -2, -2)
check 2 * a == a * 2 and a / 2 == (0.5, 1, 1)
check a.x + a.y + a.z == 5
check scale((1, 1), 3) == (3, 3)
check scale((1, 1, 1), (1, 2, 3)) == (1, 2, 3)
print a, (0.1, -0, 1e-20), sum([a, b]), mean([a, b])
