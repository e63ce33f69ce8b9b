let flat = plane((0, 0), (0, 0, 0))
let along = plane((0, 0), (0, 0, 1), x = (0, 0, 2))
let parallel = frame_of((0, 0), (1, 1), (2, 2))
