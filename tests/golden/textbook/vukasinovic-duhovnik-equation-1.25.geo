// Vukašinović, Duhovnik: Uniform, chord-length and centripetal parametrisation ((1.25)-(1.26), Fig 1.22)
geo 1
let data = [(0, 0, 0), (1, 1, 0), (2, 1, 0), (2.5, 0.5, 0), (4, 2, 0)]
curve by_uniform = interpolate(data, parameters = "uniform")
check [for t in [0, 1/4, 1/2, 3/4, 1]: by_uniform(t)] ~= data within 1e-12
curve by_chord = interpolate(data)
check [for t in [0, 0.26975214338981794, 0.46049571322036412, 0.59537178491527309, 1]: by_chord(t)] ~= data within 1e-12
curve by_centripetal = interpolate(data, parameters = "centripetal")
check [for t in [0, 0.26505877997167378, 0.48794575788137733, 0.6753706186123809, 1]: by_centripetal(t)] ~= data within 1e-12
check by_uniform.points ~= [(0, 0, 0), (1/3, 1/2, 0), (79/84, 97/84, 0), (53/24, 29/24, 0), (187/84, 1/84, 0), (10/3, 7/6, 0), (4, 2, 0)] within 4e-12
check by_uniform(1/2) ~= (2, 1, 0) within 2e-12
check by_chord.points ~= [
  (0, 0, 0),
  (0.25245310429357162, 0.52859547920896832, 0),
  (0.75833057419315128, 1.0404586910686069, 0),
  (1.9959074254823901, 1.2189120096867343, 0),
  (2.7816239096705114, -0.10235470326957708, 0),
  (3.5, 0.75, 0),
  (4, 2, 0),
] within 4e-12
check by_chord(1/2) ~= (2.1639444758378354, 0.86461136318075621, 0) within 2.16e-12
check by_centripetal.points ~= [
  (0, 0, 0),
  (0.29907337290772291, 0.51440453895431497, 0),
  (0.85112108166622214, 1.1003965356027837, 0),
  (2.0897506120841666, 1.2029938772477509, 0),
  (2.4980501452124331, 0.04974298269846449, 0),
  (3.3660254037844386, 1, 0),
  (4, 2, 0),
] within 4e-12
check by_centripetal(1/2) ~= (2.0399002307489043, 0.96995762449383844, 0) within 2.04e-12
