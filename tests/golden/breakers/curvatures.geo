// Figures of surfaces that have closed forms, by name: what they are checked against elsewhere.

fn grid(f) = flatten([for u in [0, 0.1, 0.37, 0.5, 0.81, 1]: [for v in [0, 0.2, 0.5, 0.63, 1]: f(u, v)]])
fn worst(f) = max([for x in grid(f): abs(x)])

// Bézier coefficients over -1..1 of 1, t, t^2 and t^3.
let one = [1, 1, 1, 1]
let t1 = [-1, -1/3, 1/3, 1]
let t2 = [1, -1/3, -1/3, 1]
let t3 = [-1, 1, -1, 1]
fn bicubic(x, y, z) = bezier([for i in 0..3: [for j in 0..3: (x(i, j), y(i, j), z(i, j))]])

test "z = xy bends by -1/(1 + x^2 + y^2)^2" {
  let saddle = bilinear((-1, -1, 1), (-1, 1, -1), (1, -1, -1), (1, 1, 1))
  check worst((u, v) => gaussian(saddle, u, v)*(1 + saddle(u, v).x^2 + saddle(u, v).y^2)^2 + 1) < 1e-12
}

test "Enneper's surface, a bicubic, is minimal" {
  let enneper = bicubic(
    (i, j) => t1[i] - t3[i]/3 + t1[i]*t2[j],
    (i, j) => t1[j] - t3[j]/3 + t1[j]*t2[i],
    (i, j) => t2[i]*one[j] - one[i]*t2[j],
  )
  check is_minimal(enneper)
  check worst((u, v) => mean(enneper, u, v)) < 1e-13
  let size = (u, v) => 1 + (2*u - 1)^2 + (2*v - 1)^2
  check worst((u, v) => gaussian(enneper, u, v)*size(u, v)^4/4 + 1) < 1e-12
}

test "the monkey saddle is planar in its middle, and an umbilic there" {
  let monkey = bicubic((i, j) => t1[i], (i, j) => t1[j], (i, j) => t3[i] - 3*t1[i]*t2[j])
  check classify(monkey, 0.5, 0.5) == "planar"
  check describe(monkey).umbilics ~= [(0.5, 0.5)] within 1e-9
}

test "an ellipsoid has four umbilics, in the plane of its longest and its shortest axis" {
  let [a, b, c] = [3, 2, 1]
  let x = a*sqrt((a^2 - b^2)/(a^2 - c^2))
  let z = c*sqrt((b^2 - c^2)/(a^2 - c^2))
  let ball = scale(sphere((0, 0), 1), (a, b, c))
  let holds = s => {
    let found = [for p in describe(s).umbilics: s(p.x, p.y)]
    len(found) == 4 and every(found, p => abs(p.x) ~= x within 1e-9 and p.y ~= 0 within 1e-9 and abs(p.z) ~= z within 1e-9)
  }
  // On a knot and on the seam; inside of a piece; of a function.
  check holds(ball)
  check holds(scale(rotate(sphere((0, 0), 1), 1rad), (a, b, c)))
  check holds(parametric((u, v) => (a*cos(u)*cos(v), b*sin(u)*cos(v), c*sin(v)), 0.1..tau + 0.1, -pi/2..pi/2))
}

test "of a sphere, a plane and a cylinder no umbilic is isolated; of a spheroid its poles are" {
  check describe(sphere((1, 2), 3)).umbilics == []
  check describe(plane_patch((0, 0), (1, 0), (0, 2))).umbilics == []
  check describe(cylinder((0, 0), 1, 2)).umbilics == []
  check describe(torus((0, 0), 3, 1)).umbilics == []
  let spheroid = scale(sphere((0, 0), 1), (1, 1, 2))
  check len(describe(spheroid).umbilics) == 2
  check every(describe(spheroid).umbilics, p => abs(spheroid(p.x, p.y).z) ~= 2 within 1e-12)
}

test "torus: K = cos v/(r(R + r cos v))" {
  let ring = torus((0, 0), 3, 1)
  // cos v = rho - R, where rho is how far from the axis.
  let rho = (u, v) => hypot(ring(u, v).x, ring(u, v).y)
  check worst((u, v) => gaussian(ring, u, v) - (rho(u, v) - 3)/rho(u, v)) < 1e-13
  check worst((u, v) => mean(ring, u, v) + (1 + (rho(u, v) - 3)/rho(u, v))/2) < 1e-13
}

test "developable: cone, cylinder, the tangents of a curve" {
  let tangents = parametric((u, v) => (u + v, u^2 + 2*u*v, u^3 + 3*u^2*v), 0..1, 0.5..2)
  check is_developable(cylinder((0, 0), 1, 2)) and is_developable(cone((0, 0), 2, 0.5, 3))
  check is_developable(tangents) and not is_developable(torus((0, 0), 3, 1))
}

test "a cyclide's lines of curvature are its isolines" {
  // Forsyth: with a^2 = b^2 + c^2.
  let [a, b, c, d] = [5, 4, 3, 1]
  let under = (u, v) => a - c*cos(u)*cos(v)
  let cyclide = parametric((u, v) => (
    (d*(c - a*cos(u)*cos(v)) + b^2*cos(u))/under(u, v),
    b*sin(u)*(a - d*cos(v))/under(u, v),
    b*sin(v)*(c*cos(u) - d)/under(u, v),
  ), 0..tau, 0..tau)
  let at = [for u in linspace(0.1, 6, 5), v in linspace(0.3, 5.5, 4): [u, v]]
  check every(at, p => abs(first_form(cyclide, p[0], p[1]).F) < 1e-12 and abs(second_form(cyclide, p[0], p[1]).M) < 1e-12)
}

test "Gauss and Bonnet: 4 pi of a sphere, 0 of a torus" {
  // Abramowitz and Stegun, table 25.4: eight nodes on each eighth of the parameters.
  let rule = [[0.1834346424956498, 0.362683783378362], [0.525532409916329, 0.3137066458778873], [0.7966664774136267, 0.2223810344533745], [0.9602898564975363, 0.1012285362903763]]
  let nodes = flatten([for k in 0..7: flatten([for r in rule: [for side in [-1, 1]: [(2*k + 1 + side*r[0])/16, r[1]/16]]])])
  let density = (s, u, v) => gaussian(s, u, v)*norm(cross(derivative(s, u, v), derivative(s, u, v, du = 0, dv = 1)))
  let total = s => sum([for p in nodes, q in nodes: p[1]*q[1]*density(s, p[0], q[0])])
  check total(sphere((1, 2, 3), 5)) ~= 4*pi within 1e-9
  check total(torus((0, 0), 3, 1)) ~= 0 within 1e-9
}

test "stripes break, have kinks, or are smooth where surfaces meet" {
  // Over x < 0 and over x > 0 heights that differ by a slope, by a bend, and by less.
  let half = (from, height) => bezier([for i in 0..3: [for j in 0..2: (from + i/3, j - 1, height[i] + 0.3*[1, -1, 1][j])]])
  let ends = c => [[c.start, tangent(c, c.domain.start)], [c.end, tangent(c, c.domain.end)]]
  // Where the stripes of a half end on the joint, by y, with how steeply they do.
  let marks = s => sort([for e in flatten([for c in zebra(s, (0.1, 0.2, 1), bands = 24): ends(c)]) if abs(e[0].x) < 1e-6: [e[0].y, e[1].y/e[1].x]], by = m => m[0])
  let before = marks(half(-1, [0, 0, 0, 0]))
  let slope = marks(half(0, [0, 0.1, 0.2, 0.3]))
  let bend = marks(half(0, [0, 0, 0.2, 0.6]))
  let more = marks(half(0, [0, 0, 0, 0.2]))
  let apart = (a, b, k) => max([for i in 0..min(len(a), len(b)) - 1: abs(a[i][k] - b[i][k])])
  check len(before) > 3 and len(bend) == len(before) and len(more) == len(before)
  check apart(before, slope, 0) > 1e-2
  check apart(before, bend, 0) < 1e-5 and apart(before, bend, 1) > 1e-2
  check apart(before, more, 0) < 1e-5 and apart(before, more, 1) < 1e-3
}

test "umbilics are found wherever they are, also close to one another" {
  let even = s => every(describe(s).umbilics, p => principal(s, p.x, p.y).k2 - principal(s, p.x, p.y).k1 ~= 0 within 1e-8)
  let valley = bezier([[(0.2, -0.5, -3.5), (-0.1, 0.8, -0.1), (-0.1, 2.1, 1.4), (-0.1, 3, 0.4), (0.1, 4.1, 0), (-0.1, 5.1, 0)],
    [(0.8, -0.3, 0), (0.9, 0.9, 0.9), (1.1, 2.2, 0.3), (1.2, 2.9, 0), (1.1, 3.9, 0.5), (0.8, 4.6, 1.2)],
    [(2, 0.1, -1.3), (2.1, 1, -0.4), (2, 2, -0.3), (2.3, 3, 0.1), (2, 3.5, 1.6), (1.9, 5, -1)]])
  check len(describe(valley).umbilics) == 2 and even(valley)
  let ridge = bezier([[(-0.2, 0.1, -10.5), (0.2, 1, -3.4), (0, 1.9, -0.4), (-0.1, 3, -0.3), (-0.2, 3.7, -2.1), (-0.1, 5, 0.1)],
    [(1.1, -0.1, 0.4), (1.3, 1, 0.4), (1, 1.7, 0), (0.7, 2.8, -0.2), (1.5, 4.1, 0.5), (1.2, 5.2, -4.6)],
    [(2.2, -0.2, 0.1), (2.3, 1.2, 1.8), (2.1, 2, 2.3), (2.1, 3, -0.4), (1.8, 4, 2), (2, 5, 0.5)],
    [(3.4, 0.2, 0.5), (3.4, 0.7, -1.5), (3, 2.1, 4), (3, 3.1, -0.2), (3, 4.2, 1.4), (3, 5, 2.8)]])
  check len(describe(ridge).umbilics) == 3 and even(ridge)
}
