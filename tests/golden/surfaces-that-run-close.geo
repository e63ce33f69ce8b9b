// Surfaces that nearly touch: a loop all of which is within the tolerance of 1e-6 of a point is a touch
// in it, any larger one a curve; two lines between which the surfaces are that near become one.

let ball = sphere((0.1, 0.2, 0.3), 2)
fn lid(below) = rotate(plane_patch((-5, -5, 2.3 - below), (10, 0), (0, 10)), 37deg)
// A circle about the pole, of radius sqrt(2*2*below).
check every(
    [1e-10, 1e-8, 3e-8, 5e-8, 2e-7, 1e-6, 3e-5],
    below => [for c in intersect(ball, lid(below)): length(c)] ~= [tau*sqrt(4*below)] within 1e-5,
)
print intersect(ball, lid(1e-13))
print intersect(ball, lid(0))

let pipe = cylinder((0, 0, -1), 1, 3)
fn wall(inside) = plane_patch((1 - inside, -3, -3), (0, 6, 0.3), (0, 0.2, 7))
check [for c in intersect(pipe, wall(1e-6)): length(c)] ~= [3, 3]
check [for c in intersect(pipe, wall(8e-8)): length(c)] ~= [3] within 1e-6

// One sphere in another, 4e-7 through it.
let through = (0.3^2 + 1 - 0.7000004^2)/0.6
check [for c in intersect(sphere((0, 0), 1), sphere((0.3, 0), 0.7000004)): length(c)] ~= [tau*sqrt(1 - through^2)] within 1e-7
check len(intersect(sphere((0, 0), 1), sphere((0.3, 0), 0.700002))) == 1

// One within another, a thousandth apart.
check intersect(sphere((0, 0), 1), sphere((0.0005, 0.0003), 1.001)) == []
