let p = (1, 2)
check p.z == 0 and p == (1, 2, 0)
check p + (1, 1, 1) == (2, 3, 1) and p - p == (0, 0)
check p * 2 == 2 * p and p / 2 == (0.5, 1) and -p == (-1, -2)
check (p + (0, 0, 3)).z == 3
print p, p.x, (1mm, 1cm)
