curve still = bezier((0, 0), (0, 0), (0, 0), (1, 1))
check tangent(still, 0) ~= unit_vector((1, 1)) "the tangent has a limit"
check curvature(still, 0) == 0 "and so has the curvature of a line"
curve cusp = bezier((0, 0), (1, 1), (0, 1), (1, 0))
print curvature(cusp, 0.5)
print torsion(cusp, 0.5)
print tangent(bezier((1, 1), (1, 1)), 0.5)
