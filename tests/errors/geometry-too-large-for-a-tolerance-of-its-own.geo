mesh m = tessellate(sphere((0, 0), 1e200))
