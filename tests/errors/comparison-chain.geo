let a = 2
check 1 < a < 3
