// A crease along the diagonal, on which places of the integral lie.
let roof = parametric((u, v) => (u, v, max(u, v)), 0..1, 0..1)
check area(roof) ~= sqrt(2) within 1e-9
check area(parametric((u, v) => (u, v, abs(u - v)), 0..1, 0..2)) ~= 2 * sqrt(3) within 1e-9
