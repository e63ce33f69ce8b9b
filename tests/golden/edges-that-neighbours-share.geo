// Surfaces that have an edge in common meet in that edge.
let [bottom, top, left, right, front, back] = box((0, 0, 0), (2, 1, 1))
print [for face in [bottom, left, right, front, back]: len(intersect(top, face))]
surface wave = bezier([for i in 0..3: [for j in 0..3: (i, j, (i - 1.5)*(j - 1)^2)]])
let [before, behind] = split(wave, u = 0.4)
let [common] = intersect(before, behind)
check common.degree == 3
check max([for p in sample(common, 20): closest(wave(0.4, _), p).distance]) < 1e-9
// Plane neighbours, and such that overlap in a part of their edges, or touch at a corner.
surface patch = plane_patch((0, 0), (1, 0), (0, 1))
print [for c in intersect(patch, plane_patch((1, 0), (1, 0), (0, 1))): [c.start, c.end]]
print [for c in intersect(patch, plane_patch((1, 0.25), (1, 0), (0, 1))): [c.start, c.end]]
// Halves of a sphere, and cylinders end to end.
let [south, north] = split(sphere((0, 0), 1), v = 0.5)
check [for c in intersect(south, north): length(c)] ~= [2*pi]
check [for c in intersect(cylinder((0, 0, 0), 1, 2), cylinder((0, 0, 2), 1, 2)): length(c)]
    ~= [2*pi]
check [for c in intersect(cylinder((0, 0, 0), 1, 2), cone((0, 0, 2), 1, 0, 2)): length(c)] ~= [2*pi]
check [for c in intersect(cylinder((0, 0), 1, 2), disc(plane((0, 0), (0, 0, 1)), 1)): length(c)]
    ~= [2*pi]
print intersect(patch, plane_patch((1, 1), (1, 0), (0, 1)))
