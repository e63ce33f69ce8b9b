// Hsu: Line between two points ((7)-(8), Assignment 2)
geo 1
curve c = line((1, -2, 3), (4, 4, -3))
check c(0) ~= (1, -2, 3) within 3e-12
check c(0.25) ~= (7/4, -1/2, 3/2) within 1.75e-12
check c(2/3) ~= (3, 2, -1) within 3e-12
check c(1) ~= (4, 4, -3) within 4e-12
