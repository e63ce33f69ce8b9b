geo 1
unit m

// The head of a bolt: a hexagonal prism whose corners a cone takes off; both stand on one plane.
let [flats, head] = [46mm, 18.7mm]
let wide = flats / sqrt(3)
curve hexagon = polyline([for k in 0..5: polar(wide, k * 60deg)], closed = true)
surface cap = revolve(polyline((0, 0, 0), (0.475 * flats, 0, 0), (wide, 0, (wide - 0.475 * flats) * tan(30deg)), (wide, 0, head), (0, 0, head)))
let prism = [extrude(hexagon, (0, 0, head)), flip(face(region(hexagon))), face(region(translate(hexagon, (0, 0, head))))]
let [blank, cone] = [for g in [prism, cap]: tessellate(g, tolerance = 0.05mm)]
mesh bolt = intersection(blank, cone)
check check_mesh(bolt).closed
check volume(bolt) < volume(blank) and volume(bolt) > 0.98 * volume(blank)

// Cut and fill: the ground as it is and as it shall be, down to one floor, within the same walls.
let levels = [[101, 102, 100.5], [100, 101.5, 101], [100.5, 100, 102], [101, 100.2, 100.8]]
surface ground = interpolate([for i in 0..3: [for j in 0..2: (20 * i, 15 * j, levels[i][j])]])
fn plane_at(z) = bilinear((0, 0, z), (0, 30, z), (60, 0, z - 0.6), (60, 30, z - 0.6))
fn earth(top) = {
    let floor = bilinear((0, 0, 90), (0, 30, 90), (60, 0, 90), (60, 30, 90))
    let walls = [for e in ["u0", "u1", "v0", "v1"]: ruled(edge(top, e), edge(floor, e))]
    tessellate(orient([top, floor, ...walls]), tolerance = 0.02m)
}
let [before, after] = [earth(ground), earth(plane_at(101.2))]
mesh cut = difference(before, after)
mesh fill = difference(after, before)
check check_mesh(cut).closed and check_mesh(fill).closed
check volume(cut) - volume(fill) ~= volume(before) - volume(after) within 1e-6m^3
check volume(before) ~= volume(intersection(before, after)) + volume(cut) within 1e-6m^3
