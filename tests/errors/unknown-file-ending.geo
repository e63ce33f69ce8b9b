curve c = bezier((0, 0), (1, 2), (2, 0))
export c to "c.obi"
export c to "noending"
export c to "c.step"
