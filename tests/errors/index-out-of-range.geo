let xs = [1, 2, 3]
print xs[3], xs[-4], xs[1..5], xs[0.5], [][0]
