curve c = bezier((0, 0), (1, 2), (2, 0))
surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))
check c(0.5) == (1, 1) and at(c, 0.5) == c(0.5)
check s(0.5, 0.5) == (0.5, 0.5, 0.25)
check map([0, 1], c) == [(0, 0), (2, 0)] "and go where a function is wanted"
check (0.5 |> c()) == (1, 1)
