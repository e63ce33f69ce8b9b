check 0.1 + 0.2 == 0.3
check length(circle((0, 0), 1)) ~= 6.28
check 1 / 3 < 1 / 4
