// A curve that bends by less than its points are rounded to bends neither way.
geo 1

curve s = bezier((0, 0), (1, 1e-17), (2, -1e-17), (3, 0))
check is_straight(s)
check inflections(s) == []
curve far = translate(bezier((0, 0), (1, 1e-10), (2, -1e-10), (3, 0)), (1e6, 1e6))
check is_straight(far)
check inflections(far) == []
curve bent = bezier((0, 0), (1, 1), (2, -1), (3, 0))
check inflections(bent) ~= [0.5]
check inflections(scale(bent, 1e-9)) ~= [0.5]
