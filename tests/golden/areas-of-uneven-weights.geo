// The unit square, whatever the weights of its corners.
fn square(a, b, c, d) =
    nurbs([[(0, 0), (0, 1)], [(1, 0), (1, 1)]], weights = [[a, b], [c, d]], degree = 1)
check area(square(1e-9, 1e-9, 1e9, 1e9)) ~= 1 within 1e-12
check area(square(1e9, 1e9, 1e-9, 1e-9)) ~= 1 within 1e-12
check area(square(1e-9, 1e9, 1e9, 1e9)) ~= 1 within 1e-12
check area(square(1e9, 1e-9, 1e-9, 1e9)) ~= 1 within 1e-12
check centroid(square(1e-9, 1e9, 1e9, 1e-9), of = "area") ~= (0.5, 0.5) within 1e-12
// Derivatives without bound.
check area(parametric((u, v) => (u^0.1, v, 0), 0..1, 0..1)) ~= 1 within 1e-11
// Periods narrower than the cells that are looked at first: a complete elliptic integral.
print area(parametric((u, v) => (u, v, 0.01*sin(1000*u)), 0..1, 0..1))
