curve c = bezier((0, 0), (1, 2), (2, 0))
export c to "c.json"
export c to "./C.json"
