// Sines through which sliding parameters would crowd.
fn wave(height, n_waves, n) = [for i in 0..n: (10*i/n, height*sin(360deg*n_waves*i/n))]
fn fit(height, n_waves, n, distance) = report(approximate(wave(height, n_waves, n), tolerance = distance))
check fit(1, 4, 999, 0.01).control_points <= 24
check fit(1, 4, 999, 0.001).control_points <= 52
check fit(3, 4, 999, 0.01).control_points <= 100
check fit(3, 4, 999, 0.001).control_points <= 180
check fit(3, 4, 199, 0.01).control_points <= 60
check every([[1, 4, 999, 0.01], [3, 4, 999, 0.01], [10, 4, 199, 0.1]], w => fit(w[0], w[1], w[2], w[3]).deviation.max <= w[3])
// At parameters that are given, too.
let steep = wave(3, 4, 999)
let own = report(interpolate(steep)).parameters
check report(approximate(steep, parameters = own, tolerance = 0.01)).control_points <= 110
// A chirp, and a spiral.
check report(approximate([for i in 0..999: (10*i/999, sin(360deg*8*(i/999)^2))], tolerance = 0.01)).control_points <= 50
check report(approximate([for i in 0..999: { let r = 0.5 + 4*i/999; r*(cos(1800deg*i/999), sin(1800deg*i/999)) }], tolerance = 0.01)).control_points <= 40
// Ninety-six sines and their tolerances; what takes nearly all of the points has few for its tolerance.
let tried = [for height in [0.5, 1, 2, 3], n_waves in [1, 2, 3, 4, 6, 8], n in [99, 199], distance in [0.01, 0.001]: { let r = report(approximate(wave(height, n_waves, n), tolerance = distance)) { n_waves: n_waves, steep: (height/distance)^0.25, distance: distance, count: r.control_points, far: r.deviation.max } }]
check len(tried) == 96
check every(tried, w => w.far <= w.distance)
check every(tried, w => w.count <= 3.5*w.n_waves*w.steep)
