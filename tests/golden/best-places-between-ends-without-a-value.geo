// No cylinder has the radius or the height 0, and there the range ends.
let most = maximize(r => volume(extrude(region(circle((0, 0), r)), (0, 0, 9mm - r))), within = 0mm..9mm)
check most ~= 6mm
check maximize(r => volume(extrude(region(circle((0, 0), r)), (0, 0, 9mm - r))), within = 0mm..9mm, report = true).value ~= 108mm^3 * pi within 1e-9

check minimize(x => x - ln(x), within = 0..8) ~= 1
check minimize(x => x + 1/x, within = 0..8) ~= 1
check minimize(x => x * ln(x), within = 0..2) ~= exp(-1)

// Beside what is defined on a part of the range alone.
check minimize(x => sqrt(x - 2), within = 0..4) ~= 2 within 1e-6
check maximize(x => sqrt(4 - x^2), within = -5..5, report = true).value ~= 2
