let m = load("data/missing.obj")
