geo 1

// Two curves, whose product is the height of a surface, cross at the origin, which lies about where the search first cuts
// the patch. All the way they are within the tolerance of what the section finds.
fn a(x, y) = y - x - 2 * x^2
fn b(x, y) = y + 0.5 * x - 2 * x^2 - 2 * x^3

fn away(f, x, y) = {
    let slope = hypot(f(x + 1e-5, y) - f(x - 1e-5, y), f(x, y + 1e-5) - f(x, y - 1e-5)) / 2e-5
    abs(f(x, y)) / slope
}

fn lines(shift) = {
    let net = [for i in 0..6: [for j in 0..6: {
        let x = i / 6 - 0.4871 - shift
        let y = j / 6 - 0.4871 + shift
        (x, y, a(x, y) * b(x, y))
    }]]
    section(interpolate(net, degree = 6, parameters = "uniform"), XY)
}

fn miss(c) = max([for t in linspace(c.domain.start, c.domain.end, 1001): {
    let p = c(t)
    min(away(a, p.x, p.y), away(b, p.x, p.y))
}])

let found = [for shift in [-1e-5, -1e-6, -1e-7, 0, 1e-7, 1e-6, 1e-5]: lines(shift)]
check every([for list in found: len(list) == 4])
check every([for list in found, c in list: min(norm(c.start), norm(c.end)) < 1e-12])
check every([for list in found, c in list: miss(c) < 1e-6])
