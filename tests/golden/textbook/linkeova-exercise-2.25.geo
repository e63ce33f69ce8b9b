// Linkeová: Rhinoceros versions of 2.20-2.24: knots (see the aliased cases) (Exercise 2.25)
geo 1
curve c_exercise_2_20 = coons_bspline([(0, 0), (0, 6), (6, 6), (6, 0), (0, 0), (0, 6), (6, 6)])
check len(decompose(c_exercise_2_20)) == 4
curve c_exercise_2_23 = coons_bspline([
  (3, 9), (9, 3), (3, -3), (0, 0), (3, 3), (9, -3), (3, -9), (-3, -3), (0, 0), (3, -3), (-3, -9), (-9, -3),
  (-3, 3), (0, 0), (-3, -3), (-9, 3), (-3, 9), (3, 3), (0, 0), (-3, 3), (3, 9),
])
check len(decompose(c_exercise_2_23)) == 18
