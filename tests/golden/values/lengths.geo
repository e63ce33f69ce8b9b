// Arc lengths: parabolas, cusps, rational curves and splines.
// Expected values: computed with 40 digits from the definitions, with mpmath, by nothing of this program.
geo 1
curve parabola = bezier((-3, 9), (0, -9), (3, 9))
check length(parabola) ~= 19.494177517217115 within 1.9e-11
curve half = bezier((-3, 9), (0, -9), (3, 9))
check length(half, range = 0.5..1) ~= 9.7470887586085575 within 9.7e-12
curve neile = polynomial([(0, 0), (0, 0), (1, 0), (0, 1)], domain = -1..2)
check length(neile) ~= 10.513125162759341 within 1.1e-9
curve nearly_a_cusp = bezier((0, 0), (1, 1), (0.0001, 1), (1, 0))
check length(nearly_a_cusp) ~= 1.828414267856675 within 1.8e-10
curve crossed = bezier((0, 0), (1, 1), (0, 1), (1, 0))
check length(crossed) ~= 1.8284271247461901 within 1.8e-10
curve rational_3 = bezier(
    [(0, 7, -7), (-6, -2, -6), (-7, -1, -1), (-8, -4, -1)],
    weights = [2, 5, 3, 5],
)
check length(rational_3) ~= 15.581084546997874 within 1.6e-9
check length(rational_3, range = 0.2..0.7) ~= 5.7352159113235802 within 5.7e-10
check parameter_at_length(rational_3, 9.053253914392993) ~= 0.3 within 1e-10
curve rational_6 = bezier(
    [(-5, 8, 7), (9, 6, 1), (-7, -1, -8), (-4, 4, -7), (-1, -9, -7), (-1, -7, -2), (-7, -1, -6)],
    weights = [5, 1, 3, 5, 3, 2, 1],
)
check length(rational_6) ~= 28.470964209982433 within 2.8e-9
check length(rational_6, range = 0.2..0.7) ~= 11.706340157293384 within 1.2e-9
check parameter_at_length(rational_6, 12.498410098573099) ~= 0.3 within 1e-10
curve rational_11 = bezier(
    [
        (7, -2, -6),
        (-4, -1, -8),
        (-4, -3, 0),
        (0, 7, -3),
        (0, 5, 7),
        (-4, -1, 2),
        (-9, -1, -8),
        (-9, -9, 7),
        (8, -3, 7),
        (6, -2, 5),
        (-6, 4, 6),
        (8, 3, 7),
    ],
    weights = [3, 2, 2, 3, 2, 2, 5, 3, 1, 2, 1, 1],
)
check length(rational_11) ~= 37.683240823188533 within 3.8e-9
check length(rational_11, range = 0.2..0.7) ~= 11.494096512062097 within 1.1e-9
check parameter_at_length(rational_11, 12.752922968848254) ~= 0.3 within 1e-10
curve spline = bspline(
    [
        (-1, 4, -4),
        (-8, -7, 3),
        (7, 0, -2),
        (0, -8, 5),
        (-4, -4, -1),
        (5, -9, -1),
        (2, 1, 8),
        (1, -2, -8),
        (0, -3, 2),
    ],
    knots = [0, 0, 0, 0, 1, 2, 2, 5, 7, 8, 8, 8, 8],
)
check length(spline) ~= 49.318864080734479 within 4.9e-9
check length(spline, range = 0.5..6.5) ~= 25.362462717964342 within 2.5e-9
