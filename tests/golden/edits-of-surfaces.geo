// Each edit leaves the surface where it was; what it makes has the form that it promises.
surface s = clamped([for i in 0..4: [for j in 0..3: (i, j, (i * j) % 3)]], degree = {u: 3, v: 2})
let places = [for u in linspace(0.1, 1.9, 5), v in linspace(0, 2, 5): [u, v]]
fn stays(t) = every(places, p => t(p[0], p[1]) ~= s(p[0], p[1]) within 1e-12)

check stays(refine(s, u = [0.25, 1.5], v = [0.5])) and stays(insert_knot(s, v = 0.5, times = 2))
check stays(elevate(s, u = 4, v = 3)) and stays(reparametrize(s, v = s.domain_v))
check elevate(s, u = 4).degree_u == 4 and elevate(s, u = 4).degree_v == 2
check every(places, p => swap_uv(s)(p[1], p[0]) ~= s(p[0], p[1]))
check reverse_u(s)(0.5, 1) ~= s(1.5, 1) and reverse_v(s)(0.5, 0.5) ~= s(0.5, 1.5)
check normal(flip(s), 0.5, 1.5) ~= -normal(s, 0.5, 0.5)

// Parts keep their parameters.
surface part = trim(s, u = 0.5..1.5, v = 1..2)
print part.domain_u, part.domain_v
check part(1.2, 1.7) ~= s(1.2, 1.7)
let [left, right] = split(s, u = 0.75)
print left.domain_u, right.domain_u, right.domain_v
check join([[left], [right]]).knots_u == s.knots_u

// Patches in a grid, and one surface of them again.
let patches = decompose(s)
print len(patches), len(patches[0]), patches[1][1].knots_u
check join(patches).knots_u == s.knots_u and join(patches).knots_v == s.knots_v
check stays(join(patches))

// The boundary.
check edge(s, "u0")(1.5) ~= s(0, 1.5) and edge(s, "v1")(0.5) ~= s(0.5, 2)
check [for e in edges(s): e.start] ~= [s(0, 0), s(2, 0), s(0, 0), s(0, 2)]
print corners(s)
print border(s).closed, border(s).domain
print len(wireframe(s, 3, [0.5])), wireframe(s, 0, [0.5])[0].degree
print len(control_net(s)), control_net(s)[0].points

// Functions have parts, too.
surface wave = parametric((u, v) => (u, v, sin(u * v)), 0..2, 0..1)
check trim(wave, u = 1..2)(1.5, 0.5) == wave(1.5, 0.5)
check swap_uv(wave)(0.5, 1.5) == wave(1.5, 0.5)
check derivative(reverse_u(wave), 0.5, 0.5) ~= -derivative(wave, 1.5, 0.5)
check derivative(swap_uv(wave), 0.5, 1.5, du = 2, dv = 1) ~= derivative(wave, 1.5, 0.5, du = 1, dv = 2)
check edge(wave, "u1")(0.5) == wave(2, 0.5) and split(wave, v = 0.5)[1].domain_v.start == 0.5
check corners(wave)[1][1] == wave(2, 1)
