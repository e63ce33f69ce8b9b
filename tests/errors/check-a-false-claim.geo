let a = 2
check a == 3 "a is three"
