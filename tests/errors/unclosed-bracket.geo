let width = 3
curve c = bezier((0, 0), (1, 2), (2, 0)
print width
