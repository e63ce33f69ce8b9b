// The half-breadth of this hull is 0.4 u (1 - u) v of its length S, its depth 0.3: the volume is
// 2 · 0.4 · 1/6 · 1/2 · 0.3 S^3 = 0.02 S^3. Where it should be 0 it is e or -e.
fn hull(S, e) = bezier([[(0, e, 0), (0, -e, 0.3*S)], [(0.5*S, -e, 0), (0.5*S, 0.2*S, 0.3*S)], [(S, 0, 0), (S, e, 0.3*S)]])
// A boat that ends in points: its sections are triangles of 0.4 u (1 - u) by 1.2 u (1 - u) on each
// side, together 0.48 ∫u^2 (1 - u)^2 = 0.016 S^3.
fn boat(S, e) = bezier([[(0, e, 0), (0, -e, e), (0, e, -e), (0, -e, 0)], [for j in 0..3: (0.5*S, 0.2*S*j/3, 0.6*S*(j/3 - 1))], [(S, -e, e), (S, e, 0), (S, -e, e), (S, e, 0)]])
fn body(port) = [port, mirror(port, ZX), ruled(port(_, 1), mirror(port, ZX)(_, 1))]
fn of_hull(S, e) = volume(body(hull(S, e))) / (0.02 * S^3)
fn of_boat(S, e) = volume(body(boat(S, e))) / (0.016 * S^3)
check of_hull(1, 0) ~= 1 within 1e-12
check of_hull(1000, 1e-13) ~= 1 within 1e-12
check of_hull(1, 4e-7) ~= 1 within 1e-4
check of_hull(1e4, 4e-7) ~= 1 within 1e-7
check of_hull(1e-3, 1e-10) ~= 1 within 1e-4
check of_boat(1, 0) ~= 1 within 1e-12
check of_boat(1000, 1e-13) ~= 1 within 1e-12
check of_boat(1, 4e-7) ~= 1 within 1e-4
check of_boat(1000, 4e-7) ~= 1 within 1e-7
check of_boat(1e4, 4e-7) ~= 1 within 1e-7
check of_boat(1e-3, 1e-10) ~= 1 within 1e-4
