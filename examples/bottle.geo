// A bottle: a profile, turned around an axis exactly, with parameters and claims.
//
//     virote run bottle.geo
//     virote run bottle.geo --set neck=15mm --set height=220mm

geo 1
unit mm

param height = 180mm in 120mm..260mm              "Height"
param body   = 34mm in 25mm..50mm                 "Radius of the body"
param neck   = 13mm in 8mm..20mm step 0.5mm       "Radius of the neck"

// Half of the outline, in the xz-plane: a cubic B-spline, whose control points are radius and height.
// Points on one vertical line make the curve straight there: the body and the neck are cylinders.
fn at_height(radius, fraction) = (radius, 0, fraction * height)

curve profile = bspline([
    at_height(0.86 * body, 0),
    at_height(body, 0.02),
    at_height(body, 0.10),
    at_height(body, 0.25),
    at_height(body, 0.40),
    at_height(body, 0.52),
    at_height(1.05 * neck, 0.66),
    at_height(neck, 0.76),
    at_height(neck, 0.84),
    at_height(neck, 0.92),
    at_height(neck, 1),
])

// The wall is the profile turned about z, exactly: u goes around, v along the profile.
surface wall = revolve(profile)

// The bottle stands on a ring, and carries a label: ruled surfaces between circles.
fn ring(radius, z) = circle((0, 0, z), radius)
surface foot  = ruled(ring(0.86 * body, 0), ring(0.6 * body, 0))
surface label = ruled(ring(1.01 * body, 0.22 * height), ring(1.01 * body, 0.38 * height))

// The surface is what was meant: its lines around are exact circles, its first line along is the profile.
let axis_distance = (u, v) => hypot(wall(u, v).x, wall(u, v).y)
let stations = linspace(0, 1, 21)
check [for u in stations, v in stations: axis_distance(u, v)]
    ~= [for u in stations, v in stations: profile(v).x] within 1e-12      "every section is a circle"
check [for v in stations: wall(0, v)] ~= [for v in stations: profile(v)] within 1e-12
check [for v in stations: wall(0.25, v).y] ~= [for v in stations: profile(v).x] within 1e-12
check wall.closed_u

// Radii.
check wall(0, 0) ~= (0.86 * body, 0, 0)                                   "the foot is narrower than the body"
check wall(0, 1) ~= (neck, 0, height)                                     "the mouth is as wide as the neck"
check bounds(profile).max.x ~= body                                       "nothing is wider than the body"
check bounds(profile).min.x ~= min(neck, 0.86 * body)                     "nothing is narrower than the neck or the foot"

// The profile is smooth: at each inner knot value, slope and bend on both sides agree.
let knots = unique(filter(profile.knots, t => 0 < t and t < 1))
fn beside(t, order, step) = derivative(profile, t + step, order = order)
check len(knots) == profile.segments - 1
check every([0, 1, 2], f = order => every(knots, f = t =>
    norm(beside(t, order, 1e-10) - beside(t, order, -1e-10)) < 1e-3))     "second derivatives are continuous"

// The body and the neck are straight, and the bends between them not too sharp for glass.
check derivative(profile, 0.25).x ~= 0                                    "the body is a cylinder"
check derivative(profile, 1).x ~= 0                                       "the neck is a cylinder"

let samples = linspace(0, 1, 101)
let bend = [for t in samples: curvature(profile, t)]
print max(bend), 1 / max(bend)
check max(bend) < 1 / 5mm                                                 "no bend is tighter than 5 mm"

mesh bottle = tessellate([wall, foot, label], tolerance = 0.05mm)
print bottle
print length(profile)

export bottle to "bottle.obj"
export table([for t in samples: {
    t,
    radius: profile(t).x,
    z: profile(t).z,
    curvature: curvature(profile, t),
}]) to "bottle.csv"
