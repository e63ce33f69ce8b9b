tolerance 0.01
check 1 ~= 1.009
check not (1 ~= 1.011)
check (0, 0) ~= (0.006, 0.006) "points by their distance"
check not ((0, 0) ~= (0.008, 0.008))
check 1 != 1.009 "but == compares exactly"
check 1 ~= 1.05 within 0.1 "and within states another"
