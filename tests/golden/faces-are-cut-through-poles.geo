// Cuts that run through a pole, where the parameter around it jumps.
fn caps(normal) = [for f in split(sphere((0, 0, 0), 1), by = plane((0, 0, 1), normal)): area(f)]
fn cap(normal) = {
    let height = 1 - normal.z / norm(normal)
    2 * pi * height
}
let normals = [(1, 0, 1), (1, 0.2, 1), (0.3, -0.7, 0.5), (0, 1, 3), (1, 0, 0.05)]
check [for n in normals: min(caps(n)) / 1mm^2] ~= [for n in normals: cap(n)] within 1e-9
check [for n in normals: sum(caps(n)) / 1mm^2] ~= [for n in normals: 4 * pi] within 1e-9

// Viviani's window: a cylinder through the centre of a sphere, of half its radius.
let window = [
    for f in split(sphere((0, 0, 0), 2), by = cylinder((1, 0, -3), 1, 6)): area(f) / 1mm^2
]
check len(window) == 3
check sum(filter(window, f = x => x < 10)) ~= 8 * (pi - 2) within 1e-9
check sum(window) ~= 16 * pi within 1e-9

// The middle of a disc, and the top of a dome.
let halves = [for f in split(disc((0, 0, 0), 1), by = plane((0, 0, 0), (1, 2, 0))): area(f) / 1mm^2]
check halves ~= [pi / 2, pi / 2] within 1e-9
let dome = revolve(arc((0, 0, 0), 1, 0deg, 90deg, normal = (0, -1, 0)))
let parts = [for f in split(dome, by = plane((0, 0, 1), (1, 0.3, 2))): area(f) / 1mm^2]
check sum(parts) ~= 2 * pi within 1e-9
check min(parts) ~= cap((1, 0.3, 2)) within 1e-9
