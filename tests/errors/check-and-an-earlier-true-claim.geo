let a = 2
check a == 2
check a ~= 2.1 within 0.01
print a
