// Hsu: Lagrange four-point form ((25), Assignment 6)
geo 1
curve c = lagrange([(0, 0, 0), (1, 3, 1), (4, 2, 2), (5, 0, -1)])
check c(0) ~= (0, 0, 0) within 1e-12
check c(1/9) ~= (-11/81, 44/27, 7/81) within 1.63e-12
check c(2/9) ~= (20/81, 70/27, 38/81) within 2.59e-12
check c(1/3) ~= (1, 3, 1) within 3e-12
check c(4/9) ~= (160/81, 80/27, 124/81) within 2.96e-12
check c(5/9) ~= (245/81, 70/27, 155/81) within 3.02e-12
check c(2/3) ~= (4, 2, 2) within 4e-12
check c(7/9) ~= (385/81, 35/27, 133/81) within 4.75e-12
check c(8/9) ~= (416/81, 16/27, 56/81) within 5.14e-12
check c(1) ~= (5, 0, -1) within 5e-12
check [for i in 0..3: lagrange([for j in 0..3: (if i == j then 1 else 0, j)])(1/2).x] ~= [-1/16, 9/16, 9/16, -1/16] within 1e-12
