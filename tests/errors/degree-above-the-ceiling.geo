curve c = bezier([for i in 0..101: (i, 0)])
curve d = nurbs([for i in 0..200: (i, 0)], degree = 150)
