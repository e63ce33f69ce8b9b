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
