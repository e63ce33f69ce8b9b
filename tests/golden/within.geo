tolerance 1e-3
check 1 ~= 1.0009
check not (1 ~= 1.0011)
check 1 ~= 1.5 within 0.5
check (0, 0) ~= (0.0006, 0.0006) "points by distance"
check not ((0, 0) ~= (0.0009, 0.0009))
check [1, [2, 3]] ~= [1.0001, [2, 3]]
check not ([1, 2] ~= [1, 2, 3]) "lists of different length are not near"
check 10mm ~= 1cm within 1um
let near = 0.1 + 0.2 ~= 0.3
print near, 0.1 + 0.2 == 0.3, 0.1 + 0.2
