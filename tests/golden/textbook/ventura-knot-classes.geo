// Ventura: the counts of points that knots of order 3 are for (p.10)
geo 1
check len(bspline([for i in 0..6: (i, 0)], degree = 2, knots = [0, 0, 0, 1, 2, 3, 4, 5, 5, 5]).points) == 7
check len(bspline([for i in 0..6: (i, 0)], degree = 2, knots = [0, 0, 0, 1.0, 1.4, 2.0, 2.3, 3.0, 3.0, 3.0]).points) == 7
check bspline([for i in 0..3: (i, i^2)], knots = [0, 0, 0, 0, 1, 1, 1, 1]).points == bezier([for i in 0..3: (i, i^2)]).points
