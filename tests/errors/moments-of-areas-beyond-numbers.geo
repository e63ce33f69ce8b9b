// Moments that are beyond numbers are refused, of what is even along u or v, too.
let wide = extrude(circle((0, 0), 1e80), (0, 0, 1e80))
let plate = plane_patch((0, 0, 5), (1, 0, 0), (0, 1, 0))
print centroid([wide, plate], of = "area")
print centroid([swap_uv(wide), plate], of = "area")
print inertia([swap_uv(wide), plate], of = "area").moments
