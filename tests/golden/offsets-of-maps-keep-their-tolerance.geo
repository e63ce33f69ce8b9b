unit m
curve c = bezier((500000, 5400000), (500100, 5400200), (500300, 5400250), (500600, 5400100))
curve d = offset(c, 20)
check report(d).deviation <= 1e-6
check max([for t in linspace(0, 1, 401): abs(norm(d(t) - c(t)) - 20)]) <= 1e-6
