// A built-in with one name for several kinds is chosen by its first argument.
let row = [(0, 0), (1, 0)]
curve c = bezier(row)
surface s = bezier([row, [(0, 1), (1, 1)]])
check at(c, 0.5) == (0.5, 0)
check at(s, 0.5, 0.5) == (0.5, 0.5)
check derivative(c, 0.5) == (1, 0)
check derivative(s, 0.5, 0.5, du = 1, dv = 0) == (0, 1)
check c(0.25) == at(c, 0.25)
check s(0.25, 0.5) == at(s, 0.25, 0.5)
check translate((1, 2), (1, 1)) == (2, 3)
check translate(c, (0, 0, 5))(0) == (0, 0, 5)
print c, s
