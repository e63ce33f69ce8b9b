// The "@" sign in four representations: Linkeova, Examples 2.2, 2.6, 2.14 and 2.15.
// Two curves make it, the bowl of the letter and the stroke around it.

// Ferguson: points and tangents.
curve bowl = ferguson(
    [(47, 46), (22, 34), (31, 20), (47, 46)],
    [(-54, 21), (-3, -24), (18, -3), (6, 72)],
)
curve stroke = ferguson(
    [(47, 46), (58, 20), (64, 35), (55, 56), (26, 61), (9, 28), (47, 7)],
    [(3, -78), (12, 6), (0, 21), (-21, 18), (-30, -15), (3, -42), (81, 21)],
)

// Bezier: a polygon a segment.
curves bowl_pieces = to_bezier(bowl)
curves stroke_pieces = to_bezier(stroke)
check [for piece in bowl_pieces: piece.points] ~=
    [
        [(47, 46), (29, 53), (23, 42), (22, 34)],
        [(22, 34), (21, 26), (25, 21), (31, 20)],
        [(31, 20), (37, 19), (45, 22), (47, 46)],
    ] within 1e-12 "Example 2.6"

// Coons: one uniform B-spline, since both curves are C2 at every joint.
curve bowl_coons = to_coons(bowl)
curve stroke_coons = to_coons(stroke)
print bowl_coons.points
print stroke_coons.points
check bowl_coons.points ~=
    [(125, -11), (35, 64), (17, 31), (29, 16), (53, 25), (41, 160)] within 1e-11 "Example 2.14"
check stroke_coons.points ~=
    [
        (54, 172),
        (42, 22),
        (60, 16),
        (66, 34),
        (60, 58),
        (24, 70),
        (0, 28),
        (30, -14),
        (162, 70),
    ] within 1e-11 "Example 2.14"

// Clamped: the same, with the ends on the curve.
curve bowl_clamped = to_clamped(bowl)
curve stroke_clamped = to_clamped(stroke)
print bowl_clamped.points
print stroke_clamped.knots
check bowl_clamped.points ~=
    [(47, 46), (29, 53), (17, 31), (29, 16), (45, 22), (47, 46)] within 1e-12 "Example 2.15"
check stroke_clamped.points ~=
    [
        (47, 46),
        (48, 20),
        (60, 16),
        (66, 34),
        (60, 58),
        (24, 70),
        (0, 28),
        (20, 0),
        (47, 7),
    ] within 1e-12 "Example 2.15"

// All four draw one curve.
fn drawn(c) = [for t in linspace(0, 6, 61): c(t)]
check drawn(stroke_coons) ~= drawn(stroke) within 1e-11
check drawn(stroke_clamped) ~= drawn(stroke) within 1e-12
