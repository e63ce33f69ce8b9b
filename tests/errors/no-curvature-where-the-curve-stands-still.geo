curve still = bezier((0, 0), (0, 0), (0, 0), (1, 1))
check tangent(still, 0) ~= unit_vector((1, 1)) "the tangent has a limit"
print curvature(still, 0)
