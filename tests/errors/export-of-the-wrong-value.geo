curve c = bezier((0, 0), (1, 2), (2, 0))
table t = table({ x: [1, 2] })
export c to "c.csv"
export c to "c.stl"
export t to "t.obj"
export 5 to "five.obj"
export c to "options.json" with (tolerence = 0.1)
export c to "negative.obj" with (tolerance = -1)
