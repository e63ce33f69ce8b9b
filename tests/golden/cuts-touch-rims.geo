// Planes that touch a rim in one point, exactly and within the tolerance: both sides have volumes of closed forms, and closed meshes.
geo 1

fn turned(g) = rotate(g, 33deg, axis = (1, 2, 3))
fn is_closed(s) = every([check_mesh(tessellate(s))], c => c.closed and c.manifold and c.oriented)
fn near(s, v) = abs(volume(s) / 1mm^3 - v) < 3e-6 and abs(volume(tessellate(s, tolerance = 1e-3)) / 1mm^3 - v) < 0.02 and is_closed(s)
// Both sides of the plane through a point of the rim, moved by some distance.
fn sides(s, point, normal, by, below, above) = {
    let p = turned(plane(point + by * normal / norm(normal), normal))
    let t = turned(s)
    near(cut(t, p), below) and near(cut(t, p, keep = "above"), above)
}
let moves = [0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-7, -1e-7]

// A half ball: above is a cap of the ball.
let half = cut(solid(sphere((0, 0, 0), 1)), XY, keep = "above")
let h = 1 - sqrt(0.5)
let cap = pi * h^2 * (3 - h) / 3
check every(moves, by => sides(half, (1, 0, 0), (1, 0, 1), by, 2 / 3 * pi - cap, cap))
// The same beside the seam.
let skew = plane(polar(1, 40deg), polar(1, 40deg) + (0, 0, 1))
check near(cut(half, skew), 2 / 3 * pi - cap) and near(cut(half, skew, keep = "above"), cap)

// A rod with ends, and a cone on its base.
solid rod = solid(cylinder((0, 0, 0), 1, 3), cap = true)
check every(moves, by => sides(rod, (1, 0, 3), (-1, 0, 1), by, 2 * pi, pi))
solid hat = solid(cone((0, 0, 0), 1, 0, 2), cap = true)
let tip = 2 * sqrt(3) * pi / 27
check every(moves, by => sides(hat, (1, 0, 0), (1, 0, 1), by, 2 / 3 * pi - tip, tip))

// Further away slivers are parts like others.
check every([1e-5, -1e-5, 1e-4, -1e-4, 1e-3, -1e-3], by => {
    let p = turned(plane((1, 0, 0) + by * (1, 0, 1), (1, 0, 1)))
    let parts = [cut(turned(half), p), cut(turned(half), p, keep = "above")]
    abs(volume(parts[0]) + volume(parts[1]) - volume(half)) < 1e-6 * 1mm^3 and every(parts, is_closed)
})
