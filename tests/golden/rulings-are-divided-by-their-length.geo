// S(u, v) = (1 - v) c0(u) + v c1(u), whatever the weights of the curves.
let l = line((0, 0), (0, 1))
let scaled = [for w in [1, 3, 0.01]: nurbs([(1, 0), (1, 1)], weights = [w, w], degree = 1)]
check every(scaled, c => ruled(l, c)(0.5, 0.5) ~= (0.5, 0.5, 0) within 1e-15)
check every(scaled, c => edge_surface([l, c])(0.5, 0.5) ~= (0.5, 0.5, 0) within 1e-15)
check every(scaled, c => ruled(l, c).degree_u == 1)

let a = arc((0, 0), 2, from = 0deg, to = 90deg)
fn divides(c0, c1) = every(linspace(0, 1, 7), u => every(linspace(0, 1, 5), v => {
    norm(ruled(c0, c1)(u, v) - lerp(c0(u), c1(u), v)) < 1e-14
}))
// An arc and a line, whose denominators differ: the degree is the sum.
let slanted = line((0, 5, 1), (3, 0, 2))
check divides(a, slanted) and divides(slanted, a)
print ruled(a, slanted).degree_u
// Two arcs of different denominators; two of one, where nothing grows.
check divides(a, arc((0, 0, 3), 2, from = 0deg, to = 60deg))
check divides(a, translate(a, (0, 0, 1)))
print ruled(a, translate(a, (0, 0, 1))).degree_u
