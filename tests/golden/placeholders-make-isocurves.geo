surface s = bezier([[(0, 0), (0, 1)], [(1, 0), (1, 1, 1)], [(2, 0), (2, 1, 3)]])
curve across = s(0.5, _)
curve along = s(_, 1)
check across.degree == 1 and along.degree == 2
check across(0.25) ~= s(0.5, 0.25) and along(0.75) ~= s(0.75, 1)
let scaled = lerp(0, _, 0.5)
check scaled(10) == 5
let late = circle((0, 0), _)
check late(3).start == (3, 0)
check map([1, 2], max(_, 1.5)) == [1.5, 2]
