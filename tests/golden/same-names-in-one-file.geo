// Nothing is lost where two things of a file have one name.
curve line((0, 0), (1, 0)) curve line((0, 0), (2, 0))
export all to "both.json"
export all to "both.obj"
