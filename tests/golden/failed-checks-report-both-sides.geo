// All checks run; each failure shows both sides, the limit and the margin.
let c = bezier((0, 0), (1, 2), (2, 0))
check c(0.5).y == 1
check c(0.5).y > 1.5            "the arch is too flat"
check c(0.5) ~= (1, 1.01)
check c(0.5) ~= (1, 1.01) within 0.1
check [1, 2, 3] ~= [1, 2.5, 3]
check c.degree == 2 and c.rational
check 1 < 2
check not true
check [1, 2] == [1, 2, 3]
