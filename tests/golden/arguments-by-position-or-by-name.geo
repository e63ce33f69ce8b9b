fn box3(width, height, depth = 1) = [width, height, depth]
check box3(1, 2) == [1, 2, 1]
check box3(1, height = 2) == [1, 2, 1]
check box3(height = 2, width = 1) == [1, 2, 1]
check box3(1, 2, depth = 3) == [1, 2, 3]
check circle(center = (0, 0), radius = 2).start == (2, 0)
fn chain(a, b = a + 1) = a + b
check chain(1) == 3 "a default may use the parameters before it"
