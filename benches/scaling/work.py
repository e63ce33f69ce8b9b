"""What is measured: a row is the operation, what its size counts, the sizes, what is given, and what is asked.

`{n}` is the size. What is given is not part of the cost.
"""

# A curve that waves, of n control points, and a surface of n x n patches about.
WAVE = "curve c = bspline([for i in 0..<{n}: (i, 2*sin(1.3*i), cos(0.7*i))])"
FLAT = "curve c = bspline([for i in 0..<{n}: (i, 2*sin(1.3*i))])"
POINTS = "let p = [for i in 0..<{n}: (i, 2*sin(0.3*i), cos(0.2*i))]"
SHEET = "surface s = bspline([for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(0.8*i)*cos(0.6*j))]])"
BALLS = "regions r = [for i in 0..<{n}: region(circle((sqrt({n})*random(2*{n}, seed = 3)[2*i], sqrt({n})*random(2*{n}, seed = 3)[2*i + 1]), 0.6))]"
STAR = "region r = region(polyline([for i in 0..<{n}: polar(10 + (i % 2), i*360deg/{n})], closed = true))"
HOLES = "[for i in 1..{n}: circle((i, 1), 0.3)]"
PLATE = "region plate = region(polyline([(0, 0), ({n} + 1, 0), ({n} + 1, 2), (0, 2)], closed = true), holes = " + HOLES + ")"
BALL = "mesh a = tessellate(sphere((0, 0), 1), max_edge = 4/{n})"

K = 1000
DOUBLE = [K, 2*K, 4*K, 8*K]
SMALL = [25, 50, 100, 200]
GRID = [10, 20, 40, 80]
EXACT = [1e-3, 1e-4, 1e-5, 1e-6]

ROWS = {
    "Language": [
        ("definitions", "definitions", [4*K, 8*K, 16*K, 32*K], "", "DEFINITIONS"),
        ("a comprehension of five operations", "elements", [10**5, 10**6, 10**7 - 1], "", "sum([for i in 1..{n}: i*2 + i/3 - 1])"),
        ("`map`", "elements", [10**5, 2*10**5, 4*10**5], "let l = [for i in 1..{n}: i]", "len(map(l, f = x => x*x))"),
        ("`filter`", "elements", [10**5, 2*10**5, 4*10**5], "let l = [for i in 1..{n}: i]", "len(filter(l, f = x => x > 3))"),
        ("`fold`", "elements", [10**5, 2*10**5, 4*10**5], "let l = [for i in 1..{n}: i]", "fold(l, start = 0, f = (a, x) => a + x)"),
        ("`sort`", "elements", [10**5, 2*10**5, 4*10**5], "let l = random({n})", "len(sort(l))"),
        ("`unique`", "elements", [10*K, 20*K, 40*K], "let l = [for i in 1..{n}: i % 1000]", "len(unique(l))"),
        ("`unique` of all other numbers", "elements", [10*K, 20*K, 40*K], "let l = random({n})", "len(unique(l))"),
        ("`random`", "numbers", [10**5, 2*10**5, 4*10**5], "", "len(random({n}))"),
        ("`join` of texts", "texts", [10*K, 20*K, 40*K], "let l = [for i in 1..{n}: str(i)]", "len(join(l, \", \"))"),
        ("`table` of records", "rows", [10*K, 20*K, 40*K], "let l = [for i in 1..{n}: {{i, j: 2*i}}]", "len(table(l))"),
        ("`gradient` by n unknowns", "unknowns", [50, 100, 200, 400], "", "len(gradient(v => sum([for x in v: x*x*sin(x)]), [for i in 1..{n}: i]))"),
        ("`minimize` in n unknowns", "unknowns", [5, 10, 20, 40], "", "len(minimize(v => sum([for i in 0..<{n}: (v[i] - i)^2*(1 + i)]), start = [for i in 1..{n}: 0]))"),
        ("`integrate` of sin(nx)", "n", [10, 20, 40, 80], "", "integrate(x => sin({n}*x)^2, 0..1)"),
        ("`ode` to a tolerance", "1/tolerance", EXACT, "", "ode((t, y) => (-y.y, y.x), (1, 0), 0..6, tolerance = {n})"),
    ],
    "Curves": [
        ("`bezier`", "degree", [12, 25, 50, 100], "", "bezier([for i in 0..{n}: (i, sin(i))])"),
        ("`bezier` at a point", "degree", [12, 25, 50, 100], "curve c = bezier([for i in 0..{n}: (i, sin(i))])", "c(0.37)"),
        ("`bspline`", "control points", DOUBLE, POINTS, "bspline(p)"),
        ("`interpolate`", "points", DOUBLE, POINTS, "interpolate(p)"),
        ("`interpolate`, closed", "points", DOUBLE, POINTS, "interpolate(p, closed = true)"),
        ("`interpolate` of degree 7", "points", DOUBLE, POINTS, "interpolate(p, degree = 7)"),
        ("`lagrange`", "points", [12, 25, 50, 100], POINTS, "lagrange(p)"),
        ("`cubic_spline`", "points", DOUBLE, POINTS, "cubic_spline(p, tangents = [(1, 1), (1, 1)])"),
        ("`approximate` by n/10 control points", "points", DOUBLE, POINTS, "approximate(p, control_points = floor({n}/10))"),
        ("`approximate` within 1e-2", "points", [250, 500, K, 2*K], "let p = [for i in 0..<{n}: (20*i/{n}, sin(20*i/{n}))]", "approximate(p, tolerance = 1e-2)"),
        ("`parametric` to a spline", "1/tolerance", EXACT, "curve c = parametric(t => (t, sin(6*t), cos(4*t)), 0..3)", "to_nurbs(c, tolerance = {n})"),
        ("a point", "control points", DOUBLE, WAVE, "c(0.37*c.domain.end)"),
        ("n points", "points", [10**5, 2*10**5, 4*10**5], "curve c = bspline([for i in 0..<100: (i, sin(i))])", "len(sample(c, {n}))"),
        ("`length`", "control points", DOUBLE, WAVE, "length(c)"),
        ("`divide` into n parts", "parts", DOUBLE, "curve c = bspline([for i in 0..<100: (i, sin(i))])", "len(divide(c, {n}))"),
        ("`closest`", "control points", DOUBLE, WAVE, "closest(c, ({n}/2, 9, 3)).t"),
        ("`intersect` with a line", "control points", DOUBLE, FLAT, "len(intersect(c, line((0, 0.1), ({n}, 0.1))))"),
        ("`intersect` of two", "control points", DOUBLE, FLAT + "\ncurve d = bspline([for i in 0..<{n}: (i, sin(0.9*i))])", "len(intersect(c, d))"),
        ("`self_intersections`", "control points", [250, 500, K, 2*K], "curve c = bspline([for i in 0..<{n}: (0.3*i + 2*cos(i), 2*sin(i))])", "len(self_intersections(c))"),
        ("`section`", "control points", DOUBLE, WAVE, "len(section(c, ZX))"),
        ("`inflections`", "control points", DOUBLE, FLAT, "len(inflections(c))"),
        ("`vertices`", "control points", [250, 500, K, 2*K], FLAT, "len(vertices(c))"),
        ("`bounds`", "control points", DOUBLE, WAVE, "bounds(c)"),
        ("`insert_knot`", "control points", DOUBLE, WAVE, "insert_knot(c, 0.371)"),
        ("`refine` by n knots", "knots", DOUBLE, WAVE, "refine(c, [for i in 1..<{n}: (i - 0.5)/{n}*c.domain.end])"),
        ("`remove_knot`", "control points", DOUBLE, WAVE + "\ncurve d = insert_knot(c, 0.371)", "remove_knot(d, 0.371, tolerance = 1e-9)"),
        ("`elevate` by one", "control points", DOUBLE, WAVE, "elevate(c, 4)"),
        ("`reduce`", "control points", DOUBLE, WAVE + "\ncurve d = elevate(c, 4)", "reduce(d, tolerance = 1e-6, degree = 3)"),
        ("`split`", "control points", DOUBLE, WAVE, "len(split(c, 0.371))"),
        ("`decompose`", "control points", DOUBLE, WAVE, "len(decompose(c))"),
        ("`join` of n", "curves", DOUBLE, "curves l = [for i in 0..<{n}: line((i, i % 2), (i + 1, (i + 1) % 2))]", "join(l)"),
        ("`offset`", "control points", [25, 50, 100, 200], "curve c = bspline([for i in 0..<{n}: (4*i, sin(i))])", "offset(c, 0.5)"),
        ("`offset` to a tolerance", "1/tolerance", EXACT, "tolerance {n}\ncurve c = bspline([for i in 0..<20: (4*i, sin(i))])", "offset(c, 0.5)"),
        ("`extend`", "control points", DOUBLE, WAVE, "extend(c, 1)"),
        ("`compatible` of n", "curves", SMALL, "curves l = [for i in 0..<{n}: interpolate([for j in 0..8: (j, sin(i + j), i)])]", "len(compatible(l))"),
        ("`rotate`", "control points", DOUBLE, WAVE, "rotate(c, 30deg)"),
        ("`curvature_comb` of n teeth", "teeth", DOUBLE, "curve c = bspline([for i in 0..<100: (i, sin(i))])", "len(curvature_comb(c, samples = {n}).teeth)"),
    ],
    "Surfaces": [
        ("`bspline`", "rows and columns", GRID, "let p = [for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(i)*cos(j))]]", "bspline(p)"),
        ("`interpolate`", "rows and columns", GRID, "let p = [for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(i)*cos(j))]]", "interpolate(p)"),
        ("`skin`", "sections of n control points", GRID, "curves l = [for i in 0..<{n}: bspline([for j in 0..<{n}: (i, j, sin(i + 0.3*j))])]", "skin(l)"),
        ("`gordon`", "curves each way", GRID, "curves u = [for j in 0..<{n}: line((0, j), ({n} - 1, j))]\ncurves v = [for i in 0..<{n}: line((i, 0), (i, {n} - 1))]", "gordon(u, v)"),
        ("`gordon` of splines", "curves each way", [5, 10, 20, 40], "surface s = interpolate([for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(0.8*i)*cos(0.6*j))]])\nlet e = [for i in 0..<{n}: i/({n} - 1)]", "gordon([for t in e: s(_, t)], [for t in e: s(t, _)])"),
        ("`coons`", "control points of a side", DOUBLE[:3], "curve a = bspline([for i in 0..<{n}: (i, 0, sin(i))])\ncurve b = bspline([for i in 0..<{n}: (i, 5, sin(2*i))])", "coons([a, b], [line(a.start, b.start), line(a.end, b.end)])"),
        ("`ruled`", "control points", DOUBLE, WAVE, "ruled(c, translate(c, (0, 0, 5)))"),
        ("`revolve`", "control points", DOUBLE, "curve c = bspline([for i in 0..<{n}: (5 + sin(i), 0, i)])", "revolve(c)"),
        ("`sweep`", "control points of the path", [25, 50, 100, 200], "curve path = bspline([for i in 0..<{n}: (5*i, sin(i), cos(i))])", "sweep(circle((0, 0), 0.3, normal = (1, 0, 0)), path)"),
        ("a point", "rows and columns", GRID, SHEET, "s(0.4*s.domain_u.end, 0.3*s.domain_v.end)"),
        ("`closest`", "rows and columns", GRID, SHEET, "closest(s, ({n}/2, {n}/3, 2)).u"),
        ("`area`", "rows and columns", GRID, SHEET, "area(s)"),
        ("`volume` of a closed one", "control points along", GRID, "surface s = revolve(bspline([(0, 0, 0), ...[for i in 0..<{n}: (5 + sin(i), 0, i)], (0, 0, {n})]))", "volume(s)"),
        ("`intersect` with a line", "rows and columns", GRID, SHEET, "len(intersect(line((1, 1, -3), ({n} - 2, {n} - 2, 3)), s))"),
        ("`section`", "rows and columns", GRID, SHEET, "len(section(s, plane(({n}/2, 0, 0), (1, 0.2, 0))))"),
        ("`intersect` of two", "rows and columns", [5, 10, 20, 40], SHEET, "len(intersect(s, plane_patch((0, 0, 0.2), ({n}, 0), (0, {n}))))"),
        ("`contours` of n levels", "levels", [10, 20, 40], "surface s = bspline([for i in 0..<8: [for j in 0..<8: (i, j, sin(0.8*i)*cos(0.6*j))]])", "len(contours(s, direction = (0, 0, 1), levels = [for i in 1..{n}: i/{n} - 0.5]))"),
        ("`isophotes`", "rows and columns", [5, 10, 20, 40], SHEET, "len(isophotes(s, (0, 0, 1), [20deg]))"),
        ("`offset`", "rows and columns", [4, 8, 16], "surface s = bspline([for i in 0..<{n}: [for j in 0..<{n}: (4*i, 4*j, sin(0.8*i)*cos(0.6*j))]])", "offset(s, 0.5, tolerance = 1e-3)"),
        ("`tessellate`", "rows and columns", GRID, SHEET, "len(tessellate(s, tolerance = 1e-2).triangles)"),
        ("`tessellate` a ball", "1/tolerance", [1e-2, 1e-3, 1e-4], "surface s = sphere((0, 0), 10)", "len(tessellate(s, tolerance = {n}).triangles)"),
        ("`tessellate` of n balls", "surfaces", [100, 200, 400, 800], "surfaces l = [for i in 0..<{n}: sphere((3*i, 0), 1)]", "len(tessellate(l, tolerance = 1e-2).triangles)"),
        ("`grid_mesh`", "lines each way", [250, 500, K], "surface s = bspline([for i in 0..<50: [for j in 0..<50: (i, j, sin(i)*cos(j))]])", "len(grid_mesh(s, {n}, {n}).triangles)"),
        ("`insert_knot`", "rows and columns", GRID, SHEET, "insert_knot(s, u = 0.371)"),
        ("`elevate` by one", "rows and columns", GRID, SHEET, "elevate(s, u = 4, v = 4)"),
        ("`decompose`", "rows and columns", GRID, SHEET, "len(decompose(s))"),
        ("`continuity`", "rows and columns", GRID, SHEET, "continuity(s)"),
        ("`deviation` of two", "rows and columns", [5, 10, 20, 40], SHEET, "deviation(s, translate(s, (0, 0, 0.1)))"),
    ],
    "Regions, faces, solids": [
        ("`union` of n discs", "regions", [250, 500, K, 2*K], BALLS, "len(union(r))"),
        ("`difference` of n holes", "holes", SMALL, "region r = region(polyline([(0, 0), ({n} + 1, 0), ({n} + 1, 2), (0, 2)], closed = true))", "len(difference(r, [for i in 1..{n}: region(circle((i, 1), 0.3))])[0].holes)"),
        ("`difference` of n holes in a square", "holes", [100, 400, 1600], "region r = region(polyline([(-1, -1), (40, -1), (40, 40), (-1, 40)], closed = true))", "len(difference([r, ...[for i in 0..<{n}: region(circle((i % 40, floor(i/40)), 0.3))]])[0].holes)"),
        ("`region` of n corners", "corners", DOUBLE, "curve c = polyline([for i in 0..<{n}: polar(10, i*360deg/{n})], closed = true)", "region(c)"),
        ("`region` of a star", "legs", DOUBLE, "curve c = polyline([for i in 0..<{n}: polar(10 + (i % 2), i*360deg/{n})], closed = true)", "region(c)"),
        ("`regions` of n circles about one centre", "circles", [50, 100, 200, 400], "curves l = [for i in 1..{n}: circle((0, 0), i)]", "len(regions(l))"),
        ("`offset` of a star", "legs", SMALL, STAR, "len(offset(r, 0.2))"),
        ("`fillet` of a star", "legs", SMALL, STAR, "fillet(r, 0.01)"),
        ("`area` of a region", "legs", DOUBLE, STAR, "area(r)"),
        ("`contains` of a region", "legs", DOUBLE, STAR, "contains(r, (1, 2))"),
        ("`face` with n holes", "holes", SMALL, "curves l = [for i in 1..{n}: reversed(circle((i, 1), 0.3))]\nsurface s = plane_patch((0, 0), ({n} + 1, 0), (0, 2))", "face(s, l)"),
        ("`split` by n planes", "planes", [5, 10, 20, 40], "surface s = sphere((0, 0), 1)", "len(split(s, by = [for i in 1..{n}: plane((0, 0, 2*i/({n} + 1) - 1), (0, 0, 1))]))"),
        ("`area` of a face with n holes", "holes", SMALL, "face f = face(plane_patch((0, 0), ({n} + 1, 0), (0, 2)), [for i in 1..{n}: reversed(circle((i, 1), 0.3))])", "area(f)"),
        ("`tessellate` a face with n holes", "holes", SMALL, "face f = face(plane_patch((0, 0), ({n} + 1, 0), (0, 2)), [for i in 1..{n}: reversed(circle((i, 1), 0.3))])", "len(tessellate(f, tolerance = 1e-2).triangles)"),
        ("`extrude` of a plate with n holes", "holes", SMALL, PLATE, "extrude(plate, (0, 0, 1))"),
        ("`volume` of a plate with n holes", "holes", SMALL, PLATE + "\nsolid b = extrude(plate, (0, 0, 1))", "volume(b)"),
        ("`cut` of a plate with n holes", "holes", [12, 25, 50, 100], PLATE + "\nsolid b = extrude(plate, (0, 0, 1))", "cut(b, plane((0, 0, 0.5), (0, 0, 1)))"),
        ("`contains` of a solid", "holes", SMALL, PLATE + "\nsolid b = extrude(plate, (0, 0, 1))", "contains(b, (0.1, 0.1, 0.1))"),
    ],
    "Meshes": [
        ("`union` of two balls", "lines around", [50, 100, 200], BALL, "len(union([a, translate(a, (0.7, 0.2, 0.1))]).triangles)"),
        ("`volume`", "lines around", [100, 200, 400], BALL, "volume(a)"),
        ("`check_mesh`", "lines around", [100, 200, 400], BALL, "check_mesh(a)"),
        ("`section`", "lines around", [100, 200, 400], BALL, "len(section(a, XY))"),
        ("`planar_mesh`", "corners", SMALL, STAR, "len(planar_mesh(r).triangles)"),
    ],
    "Files": [
        ("STL", "lines each way", [250, 500, K], "surface s = bspline([for i in 0..<50: [for j in 0..<50: (i, j, sin(i)*cos(j))]])\nmesh m = grid_mesh(s, {n}, {n})", "EXPORT stl"),
        ("OBJ", "lines each way", [250, 500, K], "surface s = bspline([for i in 0..<50: [for j in 0..<50: (i, j, sin(i)*cos(j))]])\nmesh m = grid_mesh(s, {n}, {n})", "EXPORT obj"),
        ("PLY", "lines each way", [250, 500, K], "surface s = bspline([for i in 0..<50: [for j in 0..<50: (i, j, sin(i)*cos(j))]])\nmesh m = grid_mesh(s, {n}, {n})", "EXPORT ply"),
        ("GLB", "lines each way", [250, 500, K], "surface s = bspline([for i in 0..<50: [for j in 0..<50: (i, j, sin(i)*cos(j))]])\nmesh m = grid_mesh(s, {n}, {n})", "EXPORT glb"),
        ("STEP", "rows and columns", GRID, "surface m = bspline([for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(i)*cos(j))]])", "EXPORT step"),
        ("IGES", "rows and columns", GRID, "surface m = bspline([for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(i)*cos(j))]])", "EXPORT igs"),
        ("JSON", "rows and columns", GRID, "surface m = bspline([for i in 0..<{n}: [for j in 0..<{n}: (i, j, sin(i)*cos(j))]])", "EXPORT json"),
        ("DXF", "control points", DOUBLE, "curve m = bspline([for i in 0..<{n}: (i, 2*sin(1.3*i))])", "EXPORT dxf"),
        ("SVG", "control points", DOUBLE, "curve m = bspline([for i in 0..<{n}: (i, 2*sin(1.3*i))])", "EXPORT svg"),
        ("CSV", "rows", [10*K, 20*K, 40*K], "table m = table([for i in 1..{n}: {{i, j: 2.5*i}}])", "EXPORT csv"),
    ],
}
