curve spring = helix((0, 0), 3, 5, 1e12)
