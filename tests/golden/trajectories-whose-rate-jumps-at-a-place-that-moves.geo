// The rate jumps at a time that moves: 1 up to k, 3 behind it, so that the end is 1 + k + 3*(1 - k).
fn late(k) = ode((t, p) => (if t < k then 1 else 3, 0), start = (1, 0), range = 0..1, tolerance = 1e-10)
check gradient(k => late(k).end.x, 0.4) ~= -2 within 1e-9
check gradient(k => late(k)(0.39).x, 0.4) ~= 0 within 1e-9
check gradient(k => late(k)(0.41).x, 0.4) ~= -2 within 1e-9
check gradient(k => late(k)(0.7).x, 0.4) ~= -2 within 1e-9
check every([0.1, 0.25, 0.5, 0.9], k0 => gradient(k => late(k).end.x, k0) ~= -2 within 1e-9)

// At a state that moves, and where the start moves to one that does not.
check gradient(k => ode((t, p) => (if p.x < k then 1 else 3, 0), start = (0, 0), range = 0..2).end.x, 0.4) ~= -2 within 1e-6
check gradient(k => ode((t, p) => (if p.x < 1 then 1 else 3, 0), start = (k, 0), range = 0..2).end.x, 0.4) ~= 3 within 1e-6
// What starts on the jump and moves with it goes one way alone.
check gradient(k => ode((t, p) => (if p.x < k then 1 else 3, 0), start = (k, 0), range = 0..2).end.x, 0.4) ~= 1 within 1e-6

// Several jumps, of a number that stays the same between them.
check gradient(k => ode((t, p) => (floor(3 * t + k), 0), start = (0, 0), range = 0..1).end.x, 0.4) ~= 1 within 1e-6
check gradient(k => ode((t, p) => ((3 * t + k) % 1, 0), start = (0, 0), range = 0..1).end.x, 0.4) ~= 0 within 1e-6

// y' = y up to the time k, -y behind it: e^(2k - 1), by k and by the start.
fn turned(u) = ode((t, p) => (if t < u.k then p.x else -p.x, 0), start = (u.a, 0), range = 0..1, tolerance = 1e-10).end.x
check gradient(turned, {k: 0.6, a: 2}) ~= {k: 4 * exp(0.2), a: exp(0.2)} within 1e-8

// What comes in on a part of the range alone.
check gradient(k => ode((t, p) => (if t < 0.5 then 1 else k, 0), start = (0, 0), range = 0..1).end.x, 0.4) ~= 0.5 within 1e-6

// A ball on a spring of constant force: it falls from 1 with the speed v upwards, and is thrown back below 0.
fn ball(v) = ode((t, s) => [s[1], (0, if s[0].y < 0 then 200 else -9.81)], start = [(0, 1), (0, v)], range = 0..1, tolerance = 1e-9)[0].end.y
// It comes to 0 with the speed w after (v + w)/g, turns within 2*w/200, and rises with the speed w.
fn rebound(v) = {
  let g = 9.81
  let w = sqrt(v^2 + 2 * g)
  let left = 1 - (v + w) / g - 2 * w / 200
  w * left - g * left^2 / 2
}
check ball(0.5) ~= rebound(0.5) within 1e-8
check gradient(ball, 0.5) ~= gradient(rebound, 0.5) within 1e-7
// What is continuous, whatever decides it.
check gradient(k => ode((t, p) => (max(t, k), 0), start = (0, 0), range = 0..1, tolerance = 1e-9).end.x, 0.3) ~= 0.3 within 1e-8
check gradient(k => ode((t, p) => (min(t, k), 0), start = (0, 0), range = 0..1, tolerance = 1e-9).end.x, 0.3) ~= 0.7 within 1e-8
check gradient(k => ode((t, p) => (abs(t - k), 0), start = (0, 0), range = 0..1, tolerance = 1e-9).end.x, 0.3) ~= -0.4 within 1e-8
check gradient(k => ode((t, p) => (max(k - t, 0), 0), start = (0, 0), range = 0..1, tolerance = 1e-9).end.x, 0.5) ~= 0.5 within 1e-8
// Jumps of `ceil`, which is -0 before 0, and of `sign`, which is 0 at one number.
check gradient(k => ode((t, p) => (ceil(t - k), 0), start = (0, 0), range = 0..3, tolerance = 1e-9).end.x, 0.5) ~= -3 within 1e-8
check gradient(k => ode((t, p) => (sign(t - k), 0), start = (0, 0), range = 0..1, tolerance = 1e-9).end.x, 0.5) ~= -2 within 1e-8
