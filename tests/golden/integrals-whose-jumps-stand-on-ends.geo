// What moves with the end of the range stays outside of it, or inside.
check gradient(x => integrate(t => if t > x then 1 else 2, 0..x), 0.5) ~= 2 within 1e-12
check gradient(x => integrate(t => if t < x then 1 else 2, x..1), 0.5) ~= -2 within 1e-12
// Ends that stay, and what stays on them.
check gradient(x => integrate(t => if t < 0 then 5 else x, 0..2), 0.5) ~= 2 within 1e-12
// What is continuous has a derivative.
check gradient(k => integrate(x => if x < k then 0 else x - k, 0..1), 0) ~= -1 within 1e-12
check gradient(k => integrate(x => max(x - k, 0), 0..1), 1) ~= 0 within 1e-12
// Functions that have no value on the end or beyond it.
check gradient(k => integrate(x => 1 / sqrt(x), 0..k), 0.4) ~= 1 / sqrt(0.4) within 1e-9
check gradient(k => integrate(x => ln(x), 0..k), 0.4) ~= ln(0.4) within 1e-9
check gradient(k => integrate(x => ln(x - 0.1), 0.1..k), 0.4) ~= ln(0.3) within 1e-9
check gradient(k => integrate(x => k / sqrt(x), 0..1), 0.4) ~= 2 within 1e-9
// What comes to nothing at the end as well.
check gradient(k => integrate(x => k * abs(x), 0..1), 2) ~= 0.5 within 1e-12
check gradient(k => integrate(x => k * abs(sin(x)), 0..pi), 2) ~= 2 within 1e-12
// A jump that moves with the end of the range is never inside of it.
check gradient(x => integrate(t => if t < x then 1 else 2, 0..x), 0.5) == 1
check gradient(x => integrate(t => if t < x then 1 else 2, x..2), 0.5) == -2
check gradient(x => integrate(t => if t > 2*x then 3 else t, 0..2*x), 0.5) ~= 2
check gradient(x => integrate((s, t) => if s < x then t else 2*t, [0..x, 0..1]), 0.5) ~= 0.5
check gradient(k => integrate(t => k*abs(t), 0..1), 0.5) ~= 0.5
check gradient(x => integrate(t => abs(t), 0..x), 0.5) == 0.5
