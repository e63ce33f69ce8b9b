geo 1

// The cells of a grid, and those of a mesh within a tolerance, as faces of four corners.
surface patch = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]])
mesh grid = grid_mesh(patch, 2, 1, quads = true)
check grid.triangles == grid_mesh(patch, 2, 1).triangles
print grid, grid.faces
export grid to "grid.obj"

// At the poles of a sphere cells are triangles.
let ball = grid_mesh(sphere((0, 0, 0), 1), 8, 6, quads = true)
print "of {len(ball.faces)} faces {count(ball.faces, 3)} are triangles"
fn count(faces, n) = len([for f in faces if len(f) == n: f])

// Triangles within a tolerance and faces within it are the same triangles.
surface ring = torus((0, 0, 0), 3, 1)
let plain = tessellate(ring, tolerance = 0.1)
let cells = tessellate(ring, tolerance = 0.1, quads = true)
check area(cells) ~= area(plain)
check len(cells.triangles) == len(plain.triangles)
check 0.85 * len(cells.faces) < count(cells.faces, 4)
check check_mesh(cells).closed
