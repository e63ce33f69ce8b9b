geo 1

// What is measured of a shape far from 1 is that of the shape at 1, scaled, or an error.
fn wedge(s) = mesh([(0, 0, 0), (s, 0, 0), (0, s, 0), (0, 0, s)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
check area(wedge(1e-150)) / 1e-300 ~= 1.5 + sqrt(3) / 2
check area(wedge(1e150)) / 1e300 ~= 1.5 + sqrt(3) / 2
check volume(wedge(1e-100)) / 1e-300 ~= 1 / 6
check volume(wedge(1e100)) / 1e300 ~= 1 / 6
check centroid(wedge(1e300)).x / 1e300 ~= 0.25
check centroid(wedge(1e-300)).x / 1e-300 ~= 0.25
check check_mesh(wedge(1e-300)).euler == 2 and check_mesh(wedge(1e300)).euler == 2
check area(plane_patch((0, 0), (1e-150, 0), (0, 1e-150))) / 1e-300 ~= 1

fn wave(s) = bezier((0, 0), (s, 2 * s), (2 * s, -2 * s), (3 * s, 0))
let extremes = [1e-300, 1e-150, 1e150, 1e300]
check [for s in extremes: inflections(wave(s))[0]] ~= [0.5, 0.5, 0.5, 0.5]
check [for s in extremes: len(vertices(wave(s)))] == [2, 2, 2, 2]
check [for s in extremes: closest(bezier((0, 0), (s, 2 * s), (2 * s, 0)), (s, 3 * s)).t] ~= [0.5, 0.5, 0.5, 0.5]
