// Closed forms.
let r = 2
surface ball = parametric((u, v) => (5 + r*cos(u)*cos(v), r*sin(u)*cos(v), r*sin(v)), 0..tau, -pi/2..pi/2)
check area(ball) ~= 4*pi*r^2 within 1e-11
check volume(ball) ~= 4/3*pi*r^3 within 1e-11
check centroid(ball) ~= (5, 0, 0) within 1e-12
check inertia(ball).moments ~= [for i in 1..3: 2/5*volume(ball)*(r*1mm)^2] within 1e-10
check inertia(ball, of = "area").moments ~= [for i in 1..3: 2/3*area(ball)*(r*1mm)^2] within 1e-9

surface ring = parametric((u, v) => ((3 + cos(v))*cos(u), (3 + cos(v))*sin(u), sin(v)), 0..tau, 0..tau)
check area(ring) ~= 4*pi^2*3 within 1e-10
check volume(ring) ~= 2*pi^2*3 within 1e-10

// A can: its lid and its bottom face whichever way they like.
surface side = parametric((u, v) => (r*cos(u), r*sin(u), v), 0..tau, 0..3)
surface bottom = parametric((u, v) => (v*cos(u), v*sin(u), 0), 0..tau, 0..r)
surface lid = parametric((u, v) => (v*cos(u), v*sin(u), 3), 0..tau, 0..r)
check volume([side, bottom, lid]) ~= 3*pi*r^2 within 1e-11
check volume([lid, side, bottom]) ~= 3*pi*r^2 within 1e-11
check centroid([side, bottom, lid]) ~= (0, 0, 1.5) within 1e-12
check area([side, bottom, lid]) ~= 2*pi*r*3 + 2*pi*r^2 within 1e-11
check inertia([side, bottom, lid]).tensor ~= [[3*pi*r^2*(3*r^2 + 9)/12, 0, 0], [0, 3*pi*r^2*(3*r^2 + 9)/12, 0], [0, 0, 3*pi*r^4/2]] within 1e-9

// A cone: its apex is an edge that is collapsed.
surface coat = parametric((u, v) => (r*(1 - v)*cos(u), r*(1 - v)*sin(u), 3*v), 0..tau, 0..1)
check area(coat) ~= pi*r*hypot(r, 3) within 1e-11
check volume([coat, bottom]) ~= pi*r^2*3/3 within 1e-11
check centroid([coat, bottom]) ~= (0, 0, 3/4) within 1e-12
check centroid(coat, of = "area") ~= (0, 0, 1) within 1e-12

// An ellipsoid.
surface egg = parametric((u, v) => (1*cos(u)*cos(v), 2*sin(u)*cos(v), 3*sin(v)), 0..tau, -pi/2..pi/2)
check volume(egg) ~= 4/3*pi*1*2*3 within 1e-11
check inertia(egg).moments ~= [for q in [1 + 4, 1 + 9, 4 + 9]: volume(egg)/5*q*1mm^2] within 1e-10
check abs(inertia(egg).axes[0].z) ~= 1 and abs(inertia(egg).axes[2].x) ~= 1

// A brick of six patches, each as it comes.
fn brick(a, b, c) = [
  bilinear((0, 0, 0), (0, b, 0), (a, 0, 0), (a, b, 0)), bilinear((0, 0, c), (0, b, c), (a, 0, c), (a, b, c)),
  bilinear((0, 0, 0), (0, 0, c), (0, b, 0), (0, b, c)), bilinear((a, 0, 0), (a, b, 0), (a, 0, c), (a, b, c)),
  bilinear((0, 0, 0), (a, 0, 0), (0, 0, c), (a, 0, c)), bilinear((a, b, 0), (0, b, 0), (a, b, c), (0, b, c)),
]
check volume(brick(1, 2, 3)) ~= 6 within 1e-14
check area(brick(1, 2, 3)) ~= 22 within 1e-13
check centroid(brick(1, 2, 3)) ~= (0.5, 1, 1.5) within 1e-14
check inertia(brick(1, 2, 3)).tensor ~= [[6.5, 0, 0], [0, 5, 0], [0, 0, 2.5]] within 1e-13
check volume(translate(brick(1, 2, 3), (100, 200, -300))) ~= 6 within 1e-10
check volume(scale(brick(1, 2, 3), 2)) ~= 48 within 1e-12

// A hole: the inner ball faces inward.
surface hole = parametric((u, v) => (5 + cos(u)*cos(v), -sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2)
check volume([ball, hole]) ~= 4/3*pi*(r^3 - 1) within 1e-10
check volume(hole) ~= 4/3*pi within 1e-11 "alone it is a body"

// Enneper's surface: |Su x Sv| = (1 + u^2 + v^2)^2.
surface enneper = parametric((u, v) => (u - u^3/3 + u*v^2, v - v^3/3 + v*u^2, u^2 - v^2), -1..1, -1..1)
check area(enneper) ~= 532/45 within 1e-11
check is_minimal(enneper) and not is_developable(enneper) and not is_planar(enneper)
check not is_minimal(ball) and not is_developable(ball)
check is_developable(side) and is_developable(coat) and is_developable(lid)
check is_developable(parametric((u, v) => (cos(u) - v*sin(u), sin(u) + v*cos(u), u + v), 0..5, 0..2)) "tangents of a helix"
check is_planar(lid) and not is_planar(side) and is_planar(bezier([[(0, 0), (0, 1)], [(1, 0), (3, 1)]]))

// How far one surface is from another, whatever the parameters are.
surface patch = bilinear((0, 0, 1), (0, 4, 1), (4, 0, 1), (4, 4, 1.5))
surface plate = bilinear((0, 0), (4, 0), (0, 4), (4, 4))
check deviation(patch, plate).max ~= 1.5 and deviation(patch, plate).at ~= (4, 4, 1.5)
check deviation(plate, plate).max ~= 0
check deviation([(1, 1, 2), (6, 0, 0)], plate) ~= {max: 2, mean: 2, at: (1, 1, 2)}

// Where the speed of a parameter grows beyond bounds, or weights are far apart.
check area(parametric((u, v) => (sqrt(u), v, 0), 0..1, 0..1)) ~= 1 within 1e-9
check area(parametric((u, v) => (ln(u), v, 0), 1e-7..1, 0..1)) ~= 7*ln(10) within 1e-9
let [light, heavy] = [1e-6, 1e6]
let tent = nurbs([for i in 0..2: [for j in 0..2: (i, j, if i == 1 and j == 1 then 5 else 0)]], weights = [[1, light, 1], [light, heavy, light], [1, light, 1]], degree = 2)
check area(tent) ~= 4*sqrt(26) within 1e-3 "nearly a pyramid"
