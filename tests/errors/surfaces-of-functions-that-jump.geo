fn plate(height) = parametric((u, v) => (u, v, height(u, v)), 0..1, 0..1)
print area(plate((u, v) => if norm((u - 0.5, v - 0.5)) < 0.2 then 1 else 0))
print area(plate((u, v) => if u < 0.5 then 1 else 0))
print centroid(plate((u, v) => floor(3*v)), of = "area")
print integrate(p => p.z, plate((u, v) => if u + v < 1.3 then 0.1 else 0))
print integrate(x => 1/x^2, 1..1e300)
// What is steep, kinks or begins like a root is connected.
print area(plate((u, v) => sqrt(u))) > 1, area(plate((u, v) => tanh(40*(u - v)))) > 1
