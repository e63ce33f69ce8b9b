geo 1

let triangle = mesh([(0, 0), (1e-160, 0), (0, 1e-160)], [[0, 1, 2]])
let no_area = area(triangle)
let neither = area(plane_patch((0, 0), (1e-300, 0), (0, 1e-300)))
let s = 1e-150
let no_volume = volume(mesh([(0, 0, 0), (s, 0, 0), (0, s, 0), (0, 0, s)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
