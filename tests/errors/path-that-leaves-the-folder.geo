curve c = bezier((0, 0), (1, 2), (2, 0))
export c to "../c.obj"
export c to "/tmp/c.obj"
export c to "a/../../c.json"
