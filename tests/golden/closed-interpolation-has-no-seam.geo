let data = [(3, 0), (1, 2), (-2, 1), (-1, -2), (2, -1)]
curve c = interpolate(data, closed = true)
check c.start ~= (3, 0) within 1e-14 and c.end ~= c.start within 1e-14
check [for k in 0..2: derivative(c, 0, order = k)] ~= [for k in 0..2: derivative(c, 1, order = k)] within 1e-11

// The first point may stand at the end again.
check interpolate([...data, data[0]], closed = true).points == c.points
// Parameters: one more than points, for the return.
curve listed = interpolate(data, closed = true, parameters = [0, 1, 2, 3, 4, 5])
check [for t in 0..5: listed(t)] ~= [...data, data[0]] within 1e-14
check listed.degree == 3
curve even = interpolate(data, closed = true, degree = 4)
check [for k in 0..3: derivative(even, 0, order = k)] ~= [for k in 0..3: derivative(even, 1, order = k)] within 1e-8

// The periodic cubic through points of a circle: control points 3 / (2 + cos(1turn/n)) out.
fn on_circle(n) = [for i in 0..<n: (cos(i/n * 1turn), sin(i/n * 1turn))]
curve round = interpolate(on_circle(24), closed = true)
check [for p in round.points: norm(p)] ~= [for p in round.points: 3 / (2 + cos(1turn/24))] within 1e-14
