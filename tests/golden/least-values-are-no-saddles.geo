// Searches that begin on an axis of symmetry come to saddles, or to the greatest value on a circle, and leave them.
let half = sqrt(0.5)
check minimize(u => u[0] + u[1], start = [1, 1], subject = u => u[0]^2 + u[1]^2 == 1) ~= [-half, -half] within 1e-6
check maximize(u => u[0] + u[1], start = [-1, -1], subject = u => u[0]^2 + u[1]^2 == 1) ~= [half, half] within 1e-6
check minimize(p => p.y, start = (0, 1), subject = p => p.x^2 + p.y^2 == 1) ~= (0, -1) within 1e-6
check minimize(p => p.z, start = (0, 0, 1), subject = p => norm(p) == 1) ~= (0, 0, -1) within 1e-6
fn well(u) = u[0]^2 + u[1]^2 + 4*u[0]*u[1] + u[0]^4 + u[1]^4
let low = minimize(well, start = [1, 1], report = true)
check low.value ~= -0.5 within 1e-12 and abs(low.at[0] + low.at[1]) < 1e-6
check minimize(well, start = [1, 1], within = [-2..2, -2..2], report = true).value ~= -0.5 within 1e-12
check minimize(u => u[0]*u[1], start = [0.5, 0.5], within = [-1..1, -1..1], report = true).value ~= -1 within 1e-9
check minimize(u => u[0]*u[1], start = [0, 0], within = [-1..1, -1..1], report = true).value ~= -1 within 1e-9
check minimize(u => (u[0]*u[1] + 1)^2, start = [0, 0], within = [-1..1, -1..1], report = true).value ~= 0 within 1e-9
// The same by differences.
check minimize(u => u[0]*u[1] + 0*length(offset(line((0, 0), (1, 0)), 1 + u[0]^2)), start = [0.5, 0.5], within = [-1..1, -1..1], report = true).value ~= -1 within 1e-9

// Long narrow valleys are followed to their end.
fn valley(factor) = u => (1 - u[0])^2 + factor*(u[1] - u[0]^2)^2
check every([for start in [[-1.2, 1], [0, 0], [3, -1]]: minimize(valley(1e6), start = start)], f = found => found ~= [1, 1] within 1e-5)
check minimize(u => u.x + 1e8*(u.x^2 + u.y^2 - 1)^2, start = {x: 0.6, y: 0.8}) ~= {x: -1, y: 0} within 1e-4
// Conditions are led back to before they are judged.
check every([for start in [[-1.3, -0.2], [1, 1.1]]:
  minimize(u => pi*(2 + u[0])*(2 + u[1]), start = start, subject = u => u[0]^2 + u[1]^2 == 2, report = true)],
  f = found => found.value ~= pi within 1e-7)
check minimize(u => u[0]^2 + u[1], start = [1, 1], subject = u => u[1] >= 1 and u[1] <= 0.9999999999) ~= [0, 1] within 1e-6
