curve c = circle((0, 0), "ten")
curve d = bezier((0, 0), 5, (1, 2))
print "a" + 1, -"x", [1] * 2
