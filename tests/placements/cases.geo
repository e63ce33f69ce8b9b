// Regions, faces, cuts and sections with closed forms, wherever they stand and however they are turned: each number is how far
// what was measured is from its closed form, as a share of it.
geo 1
unit mm
tolerance 1e-6

param turn = 0deg in -360deg..360deg          "By how much all is turned"
param ax = 0                                  "Direction of the axis: x"
param ay = 0                                  "y"
param az = 1                                  "z"
param sx = 0                                  "By how much all is moved, in sizes: along x"
param sy = 0                                  "y"
param sz = 0                                  "z"
param size = 1                                "How large all is"

fn placed(g) = translate(scale(rotate(g, turn, axis = (ax, ay, az)), size), size * (sx, sy, sz))
fn across(origin, normal) = plane(placed(origin), rotate(normal, turn, axis = (ax, ay, az)))
fn lengths(lines) = sum([for c in lines: length(c)]) / (size * 1mm)
fn areas(parts) = sum([for p in parts: area(p)]) / (size^2 * 1mm^2)
fn filled(s) = volume(s) / (size^3 * 1mm^3)
fn off(got, right) = got / right - 1

// Regions in a plane.
fn disc_at(x, y, r) = region(circle((x, y), r))
fn rectangle_at(x, y, w, h) =
    region(polyline([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], closed = true))
let one = placed(disc_at(0, 0, 1))
let other = placed(disc_at(1, 0, 1))
let lens = 2 * pi / 3 - sqrt(3) / 2
let region_union = off(areas(union(one, other)), 2 * pi - lens)
let region_lens = off(areas(intersection(one, other)), lens)
let region_lune = off(areas(difference(one, other)), pi - lens)
let r = 1.2
let region_ring = off(areas(difference(placed(disc_at(0, 0, 2)), one)), 3 * pi)
let square = placed(rectangle_at(-1, -1, 2, 2))
let region_rounded_square = off(
    areas(intersection(square, placed(disc_at(0, 0, r)))),
    pi * r^2 - 4 * (r^2 * acos(1 / r) / 1rad - sqrt(r^2 - 1)),
)
let region_sieve = off(
    areas(difference(
        placed(rectangle_at(0, 0, 10, 10)),
        [for i in 0..4, j in 0..4: placed(disc_at(1 + 2 * i, 1 + 2 * j, 0.5))],
    )),
    100 - 25 * pi / 4,
)
let slab = placed(rectangle_at(0, 0, 4, 2))
let region_wider = off(areas(offset(slab, 0.5 * size)), 8 + 6 + pi / 4)
let region_narrower = off(areas(offset(slab, -0.5 * size)), 3)
let region_rounded = off(areas([fillet(slab, 0.5 * size)]), 8 - (4 - pi) / 4)
let oval = placed(region(ellipse((0, 0), 3, 2)))
let region_segment_of_ellipse = off(
    areas(intersection(oval, placed(rectangle_at(1, -5, 5, 10)))),
    6 * (acos(1 / 3) / 1rad - 1 / 3 * sqrt(1 - 1 / 9)),
)
let region_centroid = norm(
    centroid(intersection(one, placed(rectangle_at(-2, 0, 4, 2)))[0]) - placed((0, 4 / (3 * pi))),
) / size

// Faces.
let ball = placed(sphere((0, 0), 1))
let face_cap = off(
    areas([trim(ball, by = across((0, 0, 0.3), (0, 0, 1)), keep = "above")]),
    2 * pi * 0.7,
)
let face_half_through_poles = off(
    areas([trim(ball, by = across((0, 0, 0), (1, 2, 0)), keep = "above")]),
    2 * pi,
)
let face_tilted_cap = off(
    areas([trim(ball, by = across((0.1, 0.2, 0.2), (1, 2, 2)), keep = "below")]),
    2 * pi * 1.3,
)
let face_zone = off(
    areas([trim(
        trim(ball, by = across((0, 0, -0.2), (0, 0, 1)), keep = "above"),
        by = across((0, 0, 0.5), (0, 0, 1)),
        keep = "below",
    )]),
    2 * pi * 0.7,
)
let face_bore = off(
    areas([trim(placed(cylinder((0, 0, -3), 0.6, 6)), by = solid(ball), keep = "inside")]),
    2 * pi * 0.6 * 1.6,
)
let octant = trim(
    trim(
        trim(ball, by = across((0, 0, 0), (0, 0, 1)), keep = "above"),
        by = across((0, 0, 0), (1, 0, 0)),
        keep = "above",
    ),
    by = across((0, 0, 0), (0, 1, 0)),
    keep = "above",
)
let face_octant = off(areas([octant]), pi / 2)
let face_lune = off(
    areas([trim(
        trim(ball, by = across((0, 0, 0), (0, 1, 0)), keep = "above"),
        by = across((0, 0, 0), (-sin(50deg), cos(50deg), 0)),
        keep = "below",
    )]),
    2 * 50 / 180 * pi,
)
let face_lens_of_balls = off(
    areas([trim(ball, by = solid(placed(sphere((1, 0, 0), 1))), keep = "inside")]),
    pi,
)
let face_window_of_viviani = off(
    areas([trim(
        placed(sphere((0, 0), 2)),
        by = solid(placed(cylinder((1, 0, -3), 1, 6)), cap = true),
        keep = "inside",
    )]),
    8 * (pi - 2),
)
let face_napkin_ring = off(
    areas([trim(
        ball,
        by = solid(placed(cylinder((0, 0, -3), 0.6, 6)), cap = true),
        keep = "outside",
    )]),
    4 * pi * 0.8,
)
fn bar(axis) = placed(cylinder(-3 * axis, 1, 6, axis = axis))
let face_steinmetz = off(
    areas([trim(bar((0, 0, 1)), by = solid(bar((1, 0, 0)), cap = true), keep = "inside")]),
    8,
)
let face_hoof = off(
    areas(
        [
            trim(
                trim(
                    placed(cylinder((0, 0, 0), 1, 6)),
                    by = across((0, 0, 0), (0, 1, -1)),
                    keep = "above",
                )
                    , by = across((0, 0, 0), (0, 1, 0)), keep = "above",
            ),
        ],
    ), 2,
)
let face_oval = off(
    areas([trim(
        placed(plane_patch((-3, -3, -3), (6, 0, 0), (0, 6, 6))),
        by = solid(placed(cylinder((0, 0, -5), 1, 10)), cap = true),
        keep = "inside",
    )]),
    pi * sqrt(2),
)
let face_cone = off(
    areas([trim(
        placed(cone((0, 0, 0), 2, 0, 4)),
        by = across((0, 0, 1), (0, 0, 1)),
        keep = "above",
    )]),
    pi * 1.5 * sqrt(1.5^2 + 9),
)
let face_half_cone = off(
    areas([trim(
        placed(cone((0, 0, 0), 2, 0, 4)),
        by = across((0, 0, 0), (1, 1, 0)),
        keep = "above",
    )]),
    pi * sqrt(20),
)
let ring = placed(torus((0, 0, 0), 3, 1))
let face_axle_in_ring = off(
    areas([trim(placed(cylinder((0, 0, -2), 3, 4)), by = solid(ring), keep = "inside")]),
    12 * pi,
)
let face_half_torus = off(
    areas([trim(ring, by = across((0, 0, 0), (0, 0, 1)), keep = "above")]),
    6 * pi^2,
)
let face_torus_across = off(areas(split(ring, by = across((0, 0, 0), (1, 0, 0)))), 12 * pi^2)
let face_torus_outside = off(
    areas([trim(
        ring,
        by = solid(placed(cylinder((0, 0, -2), 3, 4)), cap = true),
        keep = "outside",
    )]),
    2 * pi * (3 * pi + 2),
)
let face_torus_inside = off(
    areas([trim(
        ring,
        by = solid(placed(cylinder((0, 0, -2), 3, 4)), cap = true),
        keep = "inside",
    )]),
    2 * pi * (3 * pi - 2),
)
let bowl = placed(bezier([
    [(-2, -2, 8), (-2, 0, 0), (-2, 2, 8)],
    [(0, -2, 0), (0, 0, -8), (0, 2, 0)],
    [(2, -2, 8), (2, 0, 0), (2, 2, 8)],
]))
let face_paraboloid = off(
    areas([trim(bowl, by = across((0, 0, 1), (0, 0, 1)), keep = "below")]),
    pi / 6 * (5^1.5 - 1),
)
let face_paraboloid_aslant = off(
    areas([trim(
        bowl,
        by = solid(placed(cylinder((0, 0, -20), 1, 40)), cap = true),
        keep = "inside",
    )]),
    pi / 6 * (5^1.5 - 1),
)
let saddle = placed(bezier([[(-2, -2, 4), (-2, 2, -4)], [(2, -2, -4), (2, 2, 4)]]))
let face_saddle = off(
    areas([trim(
        saddle,
        by = solid(placed(cylinder((0, 0, -20), 1, 40)), cap = true),
        keep = "inside",
    )]),
    2 * pi / 3 * (8^0.5 - 1),
)
let face_plate = off(
    areas([face(placed(plane_patch((0, 0), (4, 0), (0, 4))), [placed(circle((2, 2), 1))])]),
    pi,
)
let face_wall = off(
    areas([trim(
        placed(extrude(circle((0, 0), 1), (0, 0, 4))),
        by = across((0, 0, 2), (1, 0, 2)),
        keep = "below",
    )]),
    4 * pi,
)

// Solids and sections.
let solid_cap = off(
    filled(cut(solid(placed(sphere((0, 0), 2))), across((0, 0, 1), (0, 0, 1)), keep = "above")),
    5 / 3 * pi,
)
let solid_cap_aslant = off(
    filled(cut(
        solid(placed(sphere((0, 0), 2))),
        across((1 / 3, 2 / 3, 2 / 3), (1, 2, 2)),
        keep = "above",
    )),
    5 / 3 * pi,
)
// A tenth of the tolerance beside a pole.
let globe = solid(placed(sphere((0, 0), 1)))
fn over(height) = pi * (1 - height)^2 * (2 + height) / 3
let past = across((3e-7 / 5, 4e-7 / 5, 1), (3, 4, 1))
let least = (5e-7 + 1) / sqrt(26)
let solid_past_pole = off(filled(cut(globe, past, keep = "above")), over(least))
let solid_past_pole_below = off(filled(cut(globe, past)), over(-least))
let solid_half_torus = off(filled(cut(solid(ring), across((0, 0, 0), (0, 0, 1)))), 3 * pi^2)
let solid_torus_across = off(filled(cut(solid(ring), across((0, 0, 0), (1, 3, 0)))), 3 * pi^2)
let block = solid(placed(box((0, 0, 0), (1, 1, 1))))
let solid_corner = off(filled(cut(block, across((0.5, 0, 0), (1, 1, 1)))), 0.5^3 / 6)
let solid_half_block = off(filled(cut(block, across((0, 0, 0), (1, -1, 0)))), 0.5)
let solid_hoof = off(
    filled(cut(
        cut(solid(placed(cylinder((0, 0, 0), 1, 6)), cap = true), across((0, 0, 0), (0, -1, 1))),
        across((0, 0, 0), (0, 1, 0)),
        keep = "above",
    )),
    2 / 3,
)
let solid_frustum = off(
    filled(cut(solid(placed(cone((0, 0, 0), 2, 0, 4)), cap = true), across((0, 0, 2), (0, 0, 1)))),
    14 / 3 * pi,
)
let solid_plate = off(
    filled(extrude(
        difference(
            placed(rectangle_at(0, 0, 10, 10)),
            [for i in 0..4, j in 0..4: placed(disc_at(1 + 2 * i, 1 + 2 * j, 0.5))],
        )[0],
        3 * size * rotate((0, 0, 1), turn, axis = (ax, ay, az)),
    )),
    300 - 75 * pi / 4,
)
let solid_ellipsoid = off(
    filled(cut(solid(placed(scale(sphere((0, 0), 1), (1, 2, 3)))), across((0, 0, 0), (3, 1, 2)))),
    4 * pi,
)
let solid_turned = off(
    filled(cut(
        solid(placed(revolve(circle((3, 0, 0), 1, normal = (0, 1, 0))))),
        across((0, 0, 0), (1, 0, 0)),
    )),
    3 * pi^2,
)
let section_cone = off(
    areas(section(
        solid(placed(cone((0, 0, 0), 2, 0, 4)), cap = true),
        across((0, 0, 2), (0, 0, 1)),
    )),
    pi,
)
let section_hexagon = off(areas(section(block, across((0.5, 0.5, 0.5), (1, 1, 1)))), 0.75 * sqrt(3))
let section_oval = off(
    areas(section(
        solid(placed(cylinder((0, 0, -4), 1, 8)), cap = true),
        across((0, 0, 0), (0, 1, -1)),
    )),
    pi * sqrt(2),
)
let section_ring = off(
    areas(section(solid(ring), across((0, 0, 0.5), (0, 0, 1)))),
    12 * pi * sqrt(0.75),
)
let section_ball = off(areas(section(solid(ball), across((0, 0, 0.6), (0, 0, 1)))), 0.64 * pi)

// Curves in which surfaces cross.
let curve_circle = off(lengths(section(ball, across((0, 0, 0.6), (0, 0, 1)))), 1.6 * pi)
let curve_of_balls = off(lengths(intersect(ball, placed(sphere((1, 0, 0), 1)))), pi * sqrt(3))
let curve_steinmetz = off(
    lengths(intersect(bar((0, 0, 1)), bar((1, 0, 0)))),
    2 * 7.640395578055424035809524164342886583819935229294549442165,
)
let curve_of_coaxial = off(lengths(intersect(ring, placed(cylinder((0, 0, -3), 3, 6)))), 12 * pi)
let curve_oval = off(
    lengths(section(bar((0, 0, 1)), across((0, 0, 0), (0, 1, -1)))),
    7.640395578055424,
)
