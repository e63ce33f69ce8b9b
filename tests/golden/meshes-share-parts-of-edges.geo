// Edges that run together for a part only are joined there: such lists are meshes without cracks.

// A long edge beside two short ones, of other degrees, knots and directions.
surface wave = bezier([for i in 0..3: [for j in 0..3: (i, j, (i - 1.5)*(j - 1)^2)]])
let [left, right] = split(wave, u = 0.4)
let [low, high] = split(right, v = 0.7)
mesh parts = tessellate(
    [
        insert_knot(elevate(left, v = 5), v = 0.1),
        reverse_v(reverse_u(low)),
        swap_uv(reverse_u(high)),
    ],
    tolerance = 0.01,
)
check check_mesh(parts).manifold
check check_mesh(parts).oriented
check check_mesh(parts).boundaries == 1
check check_mesh(parts).euler == 1
check deviation(parts, wave).max <= 0.01
check deviation(wave, parts).max <= 0.01

// Rims that start elsewhere, one in the other direction.
surface tube = cylinder((0, 0, 0), 1, 2)
surface tip = rotate(cone((0, 0, 2), 1, 0, 1), 33deg, axis = (0, 0, 1))
surface base = reverse_u(rotate(disc(plane((0, 0, 0), (0, 0, 1)), 1), 100deg, axis = (0, 0, 1)))
mesh rocket = tessellate([tube, tip, base], tolerance = 0.01)
check check_mesh(rocket).closed
check check_mesh(rocket).oriented
check check_mesh(rocket).euler == 2
check volume(rocket) ~= 2*pi + pi/3 within 0.1

// Edges that overlap, neither along the whole of the other.
surface patch = plane_patch((0, 0), (1, 0), (0, 1))
surface above = plane_patch((1, 0.25), (1, 0), (0, 1))
surface below = plane_patch((-1, -0.5), (1, 0), (0, 0.9))
mesh steps = tessellate([patch, above, below], tolerance = 0.01)
check check_mesh(steps).components == 1
check check_mesh(steps).boundaries == 1
check check_mesh(steps).euler == 1
check sum([for line in border(steps): length(line)]) ~= 4 + 4 + 3.8 - 2*0.4 - 2*0.75

// A seam at which two fins stand: three sides at each of its edges.
surface fin = plane_patch((1, 0, 0), (1, 0, 0), (0, 0, 0.75))
surface upper_fin = plane_patch((1, 0, 0.75), (1, 0, 0), (0, 0, 1.25))
mesh finned = tessellate([tube, fin, upper_fin], tolerance = 0.01)
check check_mesh(finned).components == 1
check not check_mesh(finned).manifold
check sum([for line in border(finned): length(line)]) ~= 4*pi + 4 within 0.1

// Functions, beside other functions and beside splines.
surface hill = parametric((u, v) => (u, v, 0.3*sin(3*u)*cos(2*v)), 0..3, 0..2)
let [west, east] = split(hill, u = 1.3)
let [south, north] = split(east, v = 0.7)
mesh hills = tessellate([west, reverse_v(south), swap_uv(north)], tolerance = 0.01)
check check_mesh(hills).boundaries == 1
check check_mesh(hills).euler == 1
surface sleeve = parametric((u, v) => (cos(u), sin(u), v + 1), 0..tau, 0..1)
surface gutter = trim(cylinder((0, 0, 0), 1, 1), u = 0.1..0.7)
mesh pipe = tessellate([sleeve, gutter], tolerance = 0.01)
check check_mesh(pipe).components == 1
check check_mesh(pipe).euler == 0

// A corner that only touches an edge joins nothing, and divides nothing.
surface touching = plane_patch((1, 0.5), (1, -0.5), (1, 0.5))
mesh apart = tessellate([patch, touching])
check check_mesh(apart).components == 2
check len(apart.triangles) == 4
