curve ring = coons_bspline((0, 0), (1, 0), closed = true)
curve loop = bspline((0, 0), (1, 0), closed = true)
curve open = coons_bspline((0, 0), (1, 0), (1, 1))
