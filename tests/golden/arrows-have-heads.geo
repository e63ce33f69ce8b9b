// An arrow is one polyline: it starts at its point, ends at its tip, and its head goes around.
let along = arrows(line((0, 0), (3, 0)), "derivative", samples = 2)
check [for a in along: [a.start, a.end]] == [[(0, 0), (3, 0)], [(3, 0), (6, 0)]]
check along[0].points ~= [(0, 0), (3, 0), (2.4, 0.2), (2.4, -0.2), (3, 0)]
let slim = arrows(line((0, 0), (3, 0)), "derivative", samples = 2, head = 0.5)
check slim[0].points ~= [(0, 0), (3, 0), (1.5, 0.5), (1.5, -0.5), (3, 0)]
// A head grows with its arrow, and turns with it.
let back = arrows(line((0, 0), (3, 0)), "derivative", samples = 2, scale = -2)
check back[0].points ~= [(0, 0), (-6, 0), (-4.8, -0.4), (-4.8, 0.4), (-6, 0)]
// Without heads arrows are segments.
check arrows(line((0, 0), (3, 0)), "derivative", samples = 2, head = 0)[0].points == [(0, 0), (3, 0)]

// The arrows of a flat curve have flat heads, wherever its plane is, at an inflection too.
let wave = bezier((1, 2, 0), (1, 3, 3), (1, 5, -3), (1, 6, 0))
check every(
    [for field in ["derivative", "second", "tangent", "normal"], a in arrows(wave, field, samples = 5), p in a.points: p.x],
    x => x ~= 1 within 1e-12,
)
let meadow = plane_patch((1, 2, 3), (2, 0, 1), (0, 3, 0))
check every(arrows(meadow, "tangent_u", samples = 3), a => every(a.points, p => dot(p - (1, 2, 3), (-1, 0, 2)) ~= 0 within 1e-12))
check every(arrows(meadow, "tangent_v", samples = 3), a => every(a.points, p => dot(p - (1, 2, 3), (-1, 0, 2)) ~= 0 within 1e-12))

// On a curve in space the head lies in the osculating plane.
let thread = helix((0, 0), 2, 1, 3)
let tangents = arrows(thread, "tangent", samples = 4)
check every([for i in 0..3: dot(tangents[i].points[2] - tangents[i].start, binormal(thread, thread.domain.start + i/3*(thread.domain.end - thread.domain.start))) ~= 0 within 1e-9])

// The head of an arrow across its plane is as long and as wide as any.
let upright = arrows(circle((0, 0), 2), "binormal", samples = 5)
check every(upright, a => a.end - a.start ~= (0, 0, 1))
check every(upright, a => norm(a.points[2] - a.points[3]) ~= 2/15)
check every(upright, a => a.points[2].z ~= 0.8 and a.points[3].z ~= 0.8)

// A vector of length zero has no head.
let rest = arrows(bezier((0, 0), (0, 0), (1, 1)), "derivative", samples = 2)
check [for a in rest: len(a.points)] == [2, 5]
check [for a in arrows(circle((0, 0), 2), "normal", samples = 3, scale = 0): len(a.points)] == [2, 2, 2]
