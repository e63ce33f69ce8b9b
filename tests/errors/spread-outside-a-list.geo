let inner = [(1, 2), (2, 2)]
curve c = bezier((0, 0), ...inner)
