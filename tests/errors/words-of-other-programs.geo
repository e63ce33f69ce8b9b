print move((1, 2), 3)
print math.sin(1)
print lathe(2)
f(x) = x^2
check every x in [1, 2]
