// Branches that cross where two surfaces touch, and lines along which they touch, by closed forms.

fn total(lines) = sum([for c in lines: length(c)])
fn lies(lines, holds) = every(lines, c => every(sample(c, 40), holds))
// The complete elliptic integral of the second kind of the modulus squared 1/2.
let e_half = 1.3506438810476755

// Two equal cylinders cross in two ellipses, of half axes sqrt(2) and 1, that cross in two places.
let pipes = intersect(cylinder((0, 0, -3), 1, 6), cylinder((-3, 0, 0), 1, 6, axis = (1, 0, 0)))
check len(pipes) == 4
check total(pipes) ~= 8*sqrt(2)*e_half within 1e-5
check every(pipes, c => abs(c.start.y) ~= 1 within 1e-8 and c.start.x ~= 0 within 1e-8 and c.end.y ~= -c.start.y within 1e-8)
check lies(pipes, p => abs(p.x) ~= abs(p.z) within 1e-5)

// Viviani: a cylinder that touches a sphere from inside, where the curve crosses itself.
let window = intersect(sphere((0, 0), 2), cylinder((1, 0, -3), 1, 6))
check len(window) == 2 and every(window, c => c.closed and c.start ~= (2, 0, 0) within 1e-8)
check total(window) ~= 8*sqrt(2)*e_half within 1e-5
check lies(window, p => p.x^2 + p.y^2 ~= 2*p.x within 1e-5)

// A torus and planes that touch it: two circles of Villarceau, the figure of eight of Bernoulli's
// kind, and the circle on top.
let ring = torus((0, 0), 3, 1)
fn tilted(sine) = plane_patch((-9*sqrt(1 - sine^2), -9, -9*sine), (18*sqrt(1 - sine^2), 0, 18*sine), (0, 18))
let circles = intersect(ring, tilted(1/3))
check len(circles) == 4
check total(circles) ~= 12*pi within 1e-5
check lies(circles, p => norm(p - (0, 1, 0)) ~= 3 within 1e-5 or norm(p + (0, 1, 0)) ~= 3 within 1e-5)
let eight = intersect(ring, plane_patch((2, -9, -9), (0, 18), (0, 0, 18)))
check len(eight) == 2 and every(eight, c => c.closed and c.start ~= (2, 0, 0) within 1e-8)
check total(eight) ~= total(section(ring, plane((2, 0, 0), (1, 0, 0)))) within 1e-5
curves top = intersect(ring, plane_patch((-9, -9, 1), (18, 0), (0, 18)))
check len(top) == 1 and top[0].closed
check total(top) ~= 6*pi within 1e-5
check lies(top, p => p.z ~= 1 within 1e-6 and p.x^2 + p.y^2 ~= 9 within 1e-5)

// A sphere in the hole of a torus touches it along a circle, one beside it in a point.
curves belt = intersect(ring, sphere((0, 0), 2))
check len(belt) == 1 and belt[0].closed
check total(belt) ~= 4*pi within 1e-5
print intersect(ring, sphere((6, 0), 2))

// A cylinder and a plane along a line of both, which is the cylinder's seam.
curves seam = intersect(cylinder((0, 0), 1, 2), plane_patch((1, -2, -1), (0, 4), (0, 0, 4)))
check len(seam) == 1 and is_straight(seam[0])
check total(seam) ~= 2 within 1e-6

// Waves across one another: z = sin(12u)/10 and z = sin(12v)/10 have in common what lies over
// u - v = k*pi/6 and over u + v = (2k + 1)*pi/12.
fn wave(t) = 0.1*sin(12rad*t)
fn over(f, start, end) = length(parametric(f, start..end))
let rising = sum([for s in [0, pi/6, pi/6]: over(t => (t, t + s, wave(t)), 0, 1 - s)])
let falling = sum([for s in [pi/12, 3*pi/12, 5*pi/12, 7*pi/12]: over(t => (t, s - t, wave(t)), max(s - 1, 0), min(s, 1))])
let waves = intersect(parametric((u, v) => (u, v, wave(u)), 0..1, 0..1), parametric((u, v) => (u, v, wave(v)), 0..1, 0..1))
check total(waves) ~= rising + falling within 1e-4
check lies(waves, p => p.z ~= wave(p.x) within 1e-5 and p.z ~= wave(p.y) within 1e-5)
// Eight crossings on three and four lines, of which each ends twice.
check len(waves) == 5 + 2*3 + 2*2 + 2*4

// The monkey saddle and its tangent plane: three lines through one point.
let saddle = bezier([for i in 0..3: [for j in 0..3: (2*i/3 - 1, 2*j/3 - 1, [-1, 1, -1, 1][i] - 3*(2*i/3 - 1)*[1, -1/3, -1/3, 1][j])]])
check gaussian(saddle, 0.5, 0.5) ~= 0
let three = intersect(saddle, plane_patch((-1, -1), (2, 0), (0, 2)))
check total(three) ~= 2 + 4*sqrt(4/3) within 1e-5
check lies(three, p => min(abs(p.x), abs(p.x^2 - 3*p.y^2)) < 1e-5)
