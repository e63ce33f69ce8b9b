print move((1, 2), 3)
print math.sin(1)
print lathe(2)
f(x) = x^2
check every x in [1, 2]
print count([1, 2])
print [1, 2].size
print log(10)
print convex_hull([1])
print bounding_box(sphere((0, 0), 1))
