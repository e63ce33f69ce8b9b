// Vukašinović & Duhovnik, Advanced CAD Modeling, example (1.34): digits computed independently to 30 places.
geo 1
let data = [(0, 0), (1, 1), (2, 1), (2.5, 0.5), (4, 2)]
let at = [0, 0.26975214338981794, 0.46049571322036412, 0.59537178491527309, 1]
curve c = interpolate(data)
check c.points ~= [
    (0, 0),
    (0.25245310429357162, 0.52859547920896832),
    (0.75833057419315128, 1.0404586910686069),
    (1.9959074254823901, 1.2189120096867343),
    (2.7816239096705114, -0.10235470326957708),
    (3.5, 0.75),
    (4, 2),
] within 1e-14
check c.knots ~= [0, 0, 0, 0, ...at[1..3], 1, 1, 1, 1] within 1e-15
check [for t in at: c(t)] ~= data within 1e-14
check derivative(c, 0.1) ~= (3.3390886311828123, 4.1460362182225529) within 1e-13
check derivative(c, 0.8) ~= (3.7806076602996056, 4.0346516189438068) within 1e-13

curve by_uniform = interpolate(data, parameters = "uniform")
check by_uniform.points ~=
    [(0, 0), (1/3, 1/2), (79/84, 97/84), (53/24, 29/24), (187/84, 1/84), (10/3, 7/6), (4, 2)] within 1e-14
curve by_centripetal = interpolate(data, parameters = "centripetal")
check by_centripetal.points ~= [
    (0, 0),
    (0.29907337290772291, 0.51440453895431497),
    (0.85112108166622214, 1.1003965356027837),
    (2.0897506120841666, 1.2029938772477509),
    (2.4980501452124331, 0.04974298269846449),
    (3.3660254037844386, 1),
    (4, 2),
] within 1e-14
