geo 1
unit mm
// Faces: made of loops and cutters, over seams and through poles; asked, moved, written.

surface ball = sphere((0, 0), 10)
let high = plane((0, 0, 5), (0, 0, 1))
face cap = trim(ball, by = high, keep = "above")
face lid = face(region(circle((0, 0, 5), sqrt(75))))
print cap, lid, edges(cap), cap.loops
check area(cap) ~= 2*pi*10*5 within 1e-9
check length(cap) ~= tau*sqrt(75) within 1e-9
check centroid(cap) ~= (0, 0, 7.5) within 1e-9
check bounds(cap) ~= {min: (-sqrt(75), -sqrt(75), 5), max: (sqrt(75), sqrt(75), 10)}
check volume([cap, lid]) ~= pi*25*(30 - 5)/3 within 1e-8
check volume(mirror([lid, cap], YZ)) ~= volume([cap, lid])
check area(scale(cap, 2)) ~= 4*area(cap)

// What is asked of a surface is asked inside of a face.
check cap(0.1, 0.9) == ball(0.1, 0.9) and normal(cap, 0.1, 0.9) == normal(ball, 0.1, 0.9)
check gaussian(cap, 0.1, 0.9) ~= 0.01
check closest(cap, (20, 0, 0)).point ~= (sqrt(75), 0, 5)
check closest(cap, (0, 0, 30)).point ~= (0, 0, 10)
check [for p in [(0, 0, 10), (sqrt(75), 0, 5), (0, 0, -10), (0, 0, 5)]: contains(cap, p)]
    == ["inside", "border", "outside", "outside"]
check [for hit in intersect(cap, line((1, 2, -20), (1, 2, 20))): hit.point] ~= [(1, 2, sqrt(95))]
check length(section(cap, YZ)[0]) ~= 10*(2*pi/3) within 1e-6
check len(section(cap, XY)) == 0

// All parts, their areas together, and the one beside a point.
let post = cylinder((6, 0, -20), 3, 40)
faces parts = split(ball, by = [high, post])
print len(parts)
check sum([for part in parts: area(part)]) ~= area(ball)
face window = trim(ball, by = post, keep = (6, 0, -8))
face rest = trim(ball, by = post, keep = (-10, 0, 0))
check area(rest) + 2*area(window) ~= area(ball)
face between = trim(rest, by = high, keep = "below")
check area(between) < area(rest)

// A hole runs clockwise; loops of parameters are kept exactly.
face plate = face(
    plane_patch((0, 0), (40, 0), (0, 40)),
    [for p in [(10, 10), (30, 10), (10, 30), (30, 30)]: reversed(circle(p, 4))],
)
check area(plate) ~= 1600 - 64*pi and length(plate) ~= 160 + 32*pi
face patch = face(
    ball,
    [polyline([(0.2, 0.3), (0.4, 0.3), (0.4, 0.7), (0.2, 0.7)], closed = true)],
    space = "uv",
)
check area(patch)/area(ball) ~= area(patch.surface)*area(patch)/area(ball)^2
check normal(flip(plate), 0.05, 0.05) == -normal(plate, 0.05, 0.05)
check area(flip(patch)) ~= area(patch)

// Meshes keep to the face; files.
let m = tessellate(plate, tolerance = 0.01)
check area(m) ~= area(plate) within 0.2
print check_mesh(tessellate(cap)).closed
export cap to "cap.json"
export plate, window to "faces.step"
export plate to "faces.igs"
export plate to "plate.dxf"
export window to "window.svg"
export plate to "plate.stl" with (binary = false, tolerance = 1)
