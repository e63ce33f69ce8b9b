geo 1
print gradient(x => num("{x}")^2, 3)
print gradient(x => num(format(x, digits = 3))^2, 3)
