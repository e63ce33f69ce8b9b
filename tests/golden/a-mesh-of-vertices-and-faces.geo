geo 1

// Faces of any number of corners: areas and volumes by elementary geometry.
mesh cube = mesh(
  [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
  [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
check area(cube) == 6
check volume(cube) == 1
check bounds(cube).max == (1, 1, 1)
check check_mesh(cube).closed and check_mesh(cube).oriented
print cube, cube.faces

let corners = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
mesh tetrahedron = mesh(corners, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
check area(tetrahedron) ~= 8 * sqrt(3)
check volume(tetrahedron) ~= 8 / 3
print tetrahedron

// An L, a dart, a face with a corner on a straight side, one with two corners at one place.
mesh ell = mesh([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], [[0, 1, 2, 3, 4, 5]])
check area(ell) ~= 3
check ell.faces == [[0, 1, 2, 3, 4, 5]]
mesh dart = mesh([(0, 0), (2, 1), (0, 2), (0.5, 1)], [[0, 1, 2, 3]])
check area(dart) ~= 1.5
mesh straight = mesh([(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)], [[0, 1, 2, 3, 4]])
check area(straight) ~= 4
check check_mesh(straight).degenerate == 0
mesh doubled = mesh([(0, 0), (1, 0), (1, 0), (2, 0), (2, 2), (0, 2)], [[0, 1, 2, 3, 4, 5]])
check area(doubled) ~= 4
check doubled.faces == [[0, 1, 2, 3, 4, 5]]

// What has been done to a mesh leaves its faces.
check mesh(cube.vertices, cube.faces) == cube
check len(mirror(cube, plane((0, 0, 0), (1, 0, 0))).faces) == 6
check volume(scale(cube, 2)) ~= 8

export cube to "cube.obj"
export cube to "cube.ply" with (binary = false)
export cube to "cube.stl" with (binary = false)
export cube, ell to "faces.json"

// More corners than a byte counts.
let n = 300
mesh disc = mesh([for k in 0..<n: (cos(360deg * k / n), sin(360deg * k / n))], [[for k in 0..<n: k]])
check area(disc) ~= 0.5 * n * sin(360deg / n)
export disc to "disc.ply"
