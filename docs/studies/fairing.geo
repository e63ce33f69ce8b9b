// Fairing: half a hull of Wigley's family, measured with errors of up to three centimetres, of which moves of its
// fifty offsets make a fair one: nearly as it was measured, with few bumps and little skin.

geo 1
unit m

let n_stations = 10
let n_waterlines = 5
let n = n_stations * n_waterlines

fn wigley(i, j) = (1 - (2*i/(n_stations - 1) - 1)^2) * (1 - (1 - j/(n_waterlines - 1))^2)
let offsets = [for i in 0..<n_stations, j in 0..<n_waterlines:
    wigley(i, j) + 0.03 * sin((37*i^2 + 91*j^2 + i*j) * 1rad)]

fn hull(moves) = bspline([for i in 0..<n_stations: [for j in 0..<n_waterlines:
    (2*i, offsets[n_waterlines*i + j] + moves[n_waterlines*i + j], 0.5*j)]], degree = 3)

// How much offsets stand out from between their neighbours, along and across.
fn roughness(moves) = {
    let at = (i, j) => offsets[n_waterlines*i + j] + moves[n_waterlines*i + j]
    sum([
        for i in 1 ..< n_stations - 1, j in 0..<n_waterlines:
        (at(i - 1, j) - 2*at(i, j) + at(i + 1, j))^2
    ])
        + sum([
            for i in 0..<n_stations, j in 1 ..< n_waterlines - 1:
            (at(i, j - 1) - 2*at(i, j) + at(i, j + 1))^2
        ])
}

// What is paid for skin, bumps and moves.
fn burden(moves) = area(hull(moves)) + 3 * roughness(moves) + 20 * sum([for move in moves: move^2])

let still = [for k in 0..<n: 0]
let moves = minimize(burden, start = still)
let least = burden(moves)

surface measured = hull(still)
surface fair = hull(moves)

check max([for slope in gradient(burden, moves): abs(slope)]) < 1e-5  "nothing leads further down"
check area(fair) < area(measured)
check roughness(moves) < 0.6 * roughness(still)                         "many bumps are gone"
check max([for move in moves: abs(move)]) < 0.05                       "no offset moves by more than five centimetres"

print area(measured), area(fair), least
print roughness(moves) / roughness(still), max([for move in moves: abs(move)])
