// Bicubically blended surfaces: Piegl & Tiller, (10.37) to (10.43).
geo 1

curve c0 = bezier((0, 0, 3), (2.25, 0, 3.75), (4.5, 0, 6), (6.75, 0, 2.5), (9, 0, -2))
curve c1 = bezier((0, 9, 3), (3, 9, -2), (6, 9, 5), (9, 9, 0))
curve d0 = bezier((0, 0, 3), (0, 3, 4), (0, 6, 3), (0, 9, 3))
curve d1 = bezier((9, 0, -2), (9, 3, -3), (9, 6, 3), (9, 9, 0))
curve across_c0 = bezier((0, 9, 3), (0, 9, 3), (0, 9, -3), (0, 9, -3))
curve across_c1 = bezier((0, 9, 0), (0, 9, -3), (0, 9, -3), (0, 9, -9))
curve across_d0 = bezier((9, 0, 3), (9, 0, 3), (9, 0, -12), (9, 0, -15))
curve across_d1 = bezier((9, 0, -18), (9, 0, -18), (9, 0, -9), (9, 0, -15))

surface s = coons_bicubic(
    u = [c0, c1],
    v = [d0, d1],
    cross_u = [across_c0, across_c1],
    cross_v = [across_d0, across_d1],
)
check [s.degree_u, s.degree_v] == [4, 3]
check s.points ~= [
    [(0, 0, 3), (0, 3, 4), (0, 6, 3), (0, 9, 3)],
    [(9/4, 0, 15/4), (9/4, 3, 19/4), (9/4, 6, 0), (9/4, 9, -3/4)],
    [(9/2, 0, 6), (9/2, 3, 6), (9/2, 6, 5/2), (9/2, 9, 3/2)],
    [(27/4, 0, 5/2), (27/4, 3, 3/2), (27/4, 6, 21/4), (27/4, 9, 15/4)],
    [(9, 0, -2), (9, 3, -3), (9, 6, 3), (9, 9, 0)],
] within 1e-13
check derivative(s, 1, 1, du = 1, dv = 1) ~= (0, 0, -18) within 1e-12
check derivative(s, 0.8, 0, du = 0, dv = 1) ~= (0, 9, -2.376) within 1e-13
check report(s).averaged_twists == []

// Twists that differ: the mean is taken, a warning tells it, and the other corners stay.
curve other_c0 = bezier((0, 9, 3), (0, 9, 5), (0, 9, -3), (0, 9, -3))
surface t = coons_bicubic(
    u = [c0, c1],
    v = [d0, d1],
    cross_u = [other_c0, across_c1],
    cross_v = [across_d0, across_d1],
)
check derivative(t, 0, 0, du = 1, dv = 1) ~= (0, 0, 3) within 1e-12
check derivative(t, 0, 1, du = 1, dv = 1) ~= (0, 0, -9) within 1e-12
check t(0.3, 0) ~= c0(0.3) within 1e-14
check t(0, 0.7) ~= d0(0.7) within 1e-14
check derivative(t, 0.5, 1, du = 0, dv = 1) ~= across_c1(0.5) within 1e-13
print report(t)

// Derivatives count by the domains: the same surface over longer ones.
fn over(c, range) = reparametrize(c, range)
fn times(c, factor) = scale(c, factor)
surface wide = coons_bicubic(
    u = [over(c0, 0..2), c1],
    v = [over(d0, 1..5), d1],
    cross_u = [times(across_c0, 1/4), times(across_c1, 1/4)],
    cross_v = [times(across_d0, 1/2), times(across_d1, 1/2)],
)
check [wide.domain_u, wide.domain_v] == [0..2, 1..5]
check wide(0.6, 2) ~= s(0.3, 0.25) within 1e-13
