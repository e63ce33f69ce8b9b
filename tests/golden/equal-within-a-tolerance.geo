check 1 ~= 1 + 1e-7
check not (1 ~= 1 + 1e-5)
check (1, 2) ~= (1, 2.0000001)
check [1, (1, 2)] ~= [1.0000001, (1, 2)]
check {a: 1} ~= {a: 1.0000001}
check table({a: [1, 2]}) ~= table({a: [1.0000001, 2]})
check [1] != [1, 1] and not ([1] ~= [1, 1])
check 3 ~= 4 within 1 and not (3 ~= 4 within 0.5)
check 30deg ~= pi / 6 "against an angle a bare number is radians"
