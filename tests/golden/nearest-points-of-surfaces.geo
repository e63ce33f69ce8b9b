// The nearest point of a surface is that of the whole of it: inside, on an edge, in a corner, at a pole.
geo 1

// z = x y, with the normal (−1/4, −1/2, 1) at (1/2, 1/4).
surface saddle = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))
let foot = closest(saddle, (0.5, 0.25, 0.125) + 0.2 * (-0.25, -0.5, 1))
check foot.point ~= (0.5, 0.25, 0.125) within 1e-12
check foot.u ~= 0.5 and foot.v ~= 0.25
check closest(saddle, (2, 2, 1)) == {u: 1, v: 1, point: (1, 1, 1), distance: sqrt(2)} "a corner"
check closest(saddle, (0.5, -3, 0)).v == 0 "an edge"

// An eighth of the unit sphere, exact; its pole is the edge v = 1.
let r = sqrt(0.5)
surface eighth = nurbs(
    [
        [(1, 0, 0), (1, 0, 1), (0, 0, 1)],
        [(1, 1, 0), (1, 1, 1), (0, 0, 1)],
        [(0, 1, 0), (0, 1, 1), (0, 0, 1)],
    ],
    weights = [[1, r, 1], [r, 0.5, r], [1, r, 1]], degree = 2,
)
check closest(eighth, (0, 0, 7)) == {u: 0, v: 1, point: (0, 0, 1), distance: 6} "the pole"
check closest(eighth, (0, 0, 0)).distance ~= 1 "the centre"
check max([
    for i in 1..6, j in 1..6: norm(closest(eighth, (i, j, 5)).point - unit_vector((i, j, 5)))
]) < 1e-12
check closest(eighth, (1, 2, 2)).point ~= (1/3, 2/3, 2/3) within 1e-12
check closest(eighth, (0, 1e6, -1)).point ~= (0, 1, 0) within 1e-9 "far away"

// A bowl z = x² + y²: from a height h a circle is √(h − 1/4) away.
surface bowl = parametric((u, v) => (u, v, u^2 + v^2), -1..1, -1..1)
check closest(bowl, (0, 0, 1)).distance ~= sqrt(0.75) within 1e-12
check closest(bowl, (0.25, 0.5, 0.3125) + 0.2 * (-0.5, -1, 1)).point
    ~= (0.25, 0.5, 0.3125) within 1e-12

print closest(saddle, (0.5, -3, 0))
