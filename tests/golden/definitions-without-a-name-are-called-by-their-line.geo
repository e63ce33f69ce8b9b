point (1, 2)
curve line((0, 0), (1, 0))

curves [line((0, 0), (0, 1))]
export all to "nameless.obj"
export all to "nameless.json"
