// What a list stands first in is more likely meant as one.
region a = circle((0, 0), 2) |> region
region b = circle((9, 0), 1) |> region
region c = circle((0, 0), 0.5) |> region
let both = union(a, b)
fn areas(regions) = [for r in regions: area(r) / pi]
print areas(difference(both, c))
print [for r in both: areas(difference(r, c))]
print areas(difference([...both, c]))
print areas(difference(both))

// Nothing is in both of two that are apart, and so in nothing else as well.
print intersection(both, a), [for r in both: areas(intersection(r, a))], intersection([...both, a])

// Meshes likewise.
fn cube(x) = tessellate(box((x, 0, 0), (1, 1, 1)))
print volume(difference([cube(0), cube(5)], cube(5.5))), volume(intersection([cube(0), cube(5)], cube(0)))
