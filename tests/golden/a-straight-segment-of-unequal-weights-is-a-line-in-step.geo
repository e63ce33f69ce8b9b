// STEP's LINE runs evenly: the place is kept, the parameter of unequal weights not.
curve even = line((0, 0, 0), (3, 4, 0))
curve hurried = nurbs([(0, 0, 0), (3, 4, 0)], degree = 1, weights = [1, 3])
check norm(even(0.5) - hurried(0.5)) ~= 1.25
export even to "even.step"
export hurried to "hurried.step"
