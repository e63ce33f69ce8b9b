let z = 1
