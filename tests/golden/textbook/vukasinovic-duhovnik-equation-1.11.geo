// Vukašinović, Duhovnik: Bernstein basis n=5 ((1.11) corrected: C(n,i) t^i (1-t)^(n-i), C = n!/(i!(n-i)!))
geo 1
check [for i in 0..5: bezier([for j in 0..5: (if i == j then 1 else 0, j)])(1/3).x] ~= [32/243, 80/243, 80/243, 40/243, 10/243, 1/243] within 1e-12
check sum([for i in 0..5: bezier([for j in 0..5: (if i == j then 1 else 0, j)])(1/3).x]) ~= 1 within 1e-12
check [for i in 0..5: bezier([for j in 0..5: (if i == j then 1 else 0, j)])(0.8).x] ~= [1/3125, 4/625, 32/625, 128/625, 256/625, 1024/3125] within 1e-12
check sum([for i in 0..5: bezier([for j in 0..5: (if i == j then 1 else 0, j)])(0.8).x]) ~= 1 within 1e-12
