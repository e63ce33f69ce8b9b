fn wave(t, height = 2) = { let s = sin(t)  let c = if t > 1 then s^2 else cos(t); (t, height*c, s*c) }
curve w = parametric(wave, 0..3)
print w, w.domain, w.start, w.closed
// t > 1: (t, 2 sin^2 t, sin^3 t)
check derivative(w, 2) ~= (1, 4*sin(2)*cos(2), 3*sin(2)^2*cos(2)) within 1e-12
check derivative(w, 0.5) ~= (1, -2*sin(0.5), cos(1)) within 1e-12
check derivative(w, 0.5, order = 3) ~= (0, 2*sin(0.5), -4*cos(1)) within 1e-12
fn power(x, n) = if n == 0 then 1 else x * power(x, n - 1)
curve recursive = parametric(t => (power(t, 5), fold(1..5, 1, (a, i) => a * t), sum([for i in 1..3: t^i])), 0..2)
check derivative(recursive, 1.5) ~= (5*1.5^4, 5*1.5^4, 1 + 3 + 3*1.5^2) within 1e-12
check derivative(recursive, 1.5, order = 4) ~= (120*1.5, 120*1.5, 0) within 1e-11
surface ball = parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2)
print ball, ball.closed_u, ball.closed_v
check normal(ball, 1, 0.5) ~= ball(1, 0.5) within 1e-12
check curvature(ball(_, 0.5), 2) ~= 1/cos(0.5) within 1e-12
curve moved = translate(rotate(w, 90deg), (0, 0, 5))
check moved(2) ~= (-w(2).y, w(2).x, w(2).z + 5) within 1e-12
curve knot = clamped((0,0), (1,2), (3,1), (4,0), (5,2))
curve along = parametric(t => knot(t^2), 0..sqrt(2))
check derivative(along, 1.2) ~= 2.4 * derivative(knot, 1.44) within 1e-12
curve back = parametric(t => knot(2 - t), 0..2)
check derivative(back, 1) ~= -derivative(knot, 1) within 1e-12
curve nested = parametric(t => w(3 - t) + (0, 0, w(t).x), 0..3)
check derivative(nested, 1) ~= -derivative(w, 2) + (0, 0, 1) within 1e-12
print sample(parametric(t => (t, sqrt(1 - t^2)), -1..1), 5)
curve dims = parametric(t => polar(t * 3mm, t * 90deg) + (0, 0, 1mm * t), 0..1)
check derivative(dims, 0) ~= (3, 0, 1) within 1e-12
// Lists, choices and vectors carry derivatives too.
fn mixed(t) = (max(t, 1 - t), mean([t, t^2]), hypot(t, 2) + product(linspace(1, t, 3)))
curve several = parametric(mixed, 0..2)
check derivative(several, 1.5) ~= (1, 2, 1.5/2.5 + (1 + 2*1.5)/2) within 1e-12
curve turned = parametric(t => unit_vector(cross((cos(t), sin(t), 0), (0, 0, 2))), 0..1)
check derivative(turned, 0.5) ~= (cos(0.5), sin(0.5)) within 1e-12
curve stairs = parametric(t => (t, floor(t), t % 0.5), 0..3)
check derivative(stairs, 1.2) ~= (1, 0, 1) within 1e-12
check derivative(parametric(t => (t^t, 2^t, lerp(1, t, t)), 1..3), 2) ~= (4*(ln(2) + 1), 4*ln(2), 3) within 1e-12
check derivative(ball, 1, 0.5, du = 1, dv = 1) ~= (sin(1)*sin(0.5), -cos(1)*sin(0.5), 0) within 1e-12
check derivative(parametric(t => (t, t^9), 0..1), 0.5, order = 9) ~= (0, 362880) within 1e-6
