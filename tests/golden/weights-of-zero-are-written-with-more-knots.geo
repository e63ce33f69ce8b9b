// A half circle by a point at infinity; the formats know positive weights only.
curve half = nurbs((1, 0), (0, 1), (-1, 0), weights = [1, 0, 1], degree = 2)
curve steps = nurbs((0, 0), (1, 0), (1, 1), (2, 1), degree = 1, knots = [0, 0, 1, 1, 2, 2])
export half to "half.obj" with (free_form = true)
export steps to "steps.obj" with (free_form = true)
