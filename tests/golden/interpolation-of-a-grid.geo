// Vukašinović & Duhovnik, Advanced CAD Modeling, tables 1.1 to 1.5: digits computed independently to 30 places.
geo 1
let rows = [
  [(0, 0, 0), (1, 1, 0), (2, 1, 0), (2.5, 0.5, 0), (4, 2, 0)],
  [(0, 0.5, 2), (0.9, 2.5, 2), (1.8, 2, 2), (2.5, 1.5, 2), (3.7, 2, 2)],
  [(0, 0, 4), (1, 0.8, 4), (2, 1, 4), (3, 0.7, 4), (4, 0, 4)],
]
let at_rows = [0, 0.31923474372695998, 0.52103384977390634, 0.69549385939551824, 1]
let at_columns = [0, 0.48029825283848196, 1]
surface s = interpolate(transpose(rows), parameters = {u: at_rows, v: at_columns})
check [for column in s.points: column[2]] ~= [
  (0, 0.66770336652677591, 2.0789703870342822),
  (0.1858400307934707, 2.1643280621867565, 2.0789703870342822),
  (0.62226353175068325, 3.6246165791323818, 2.0789703870342822),
  (1.7233624465068968, 2.2987843009689655, 2.0789703870342822),
  (2.5890040576721319, 1.5591944242210883, 2.0789703870342822),
  (3.2159712155719409, 1.8327998188555315, 2.0789703870342822),
  (3.5993779800839345, 2.2959215395364107, 2.0789703870342822),
] within 3.62e-11
check s.knots_u ~= [0, 0, 0, 0, 0.31923474372695998, 0.52103384977390634, 0.69549385939551824, 1, 1, 1, 1] within 1e-11
check s.knots_v ~= [0, 0, 0, 0, 0.48029825283848196, 1, 1, 1, 1] within 1e-11
check s(1/2, 1/2) ~= (1.7063437477480165, 2.0787714320613049, 2.0789295374372297) within 2.08e-11
check derivative(s, 1/2, 1/2) ~= (4.4863402108161701, -3.6720876975030189, 0) within 4.49e-11
check derivative(s, 1/2, 1/2, du = 0, dv = 1) ~= (-0.033004769688192261, -0.036793013644118667, 4) within 4e-11
check derivative(s, 1/2, 1/2, du = 2) ~= (-4.1008572462605595, -1.4686354032652776, 0) within 4.1e-11
check derivative(s, 1/2, 1/2, du = 0, dv = 2) ~= (1.5358190826305505, -8.4314856751525153, -0.63143629949783757) within 8.43e-11
check s(0.25, 0.7) ~= (0.65703753271595559, 2.0835587933666319, 2.8663008114472729) within 2.87e-11
check s(0.9, 0.1) ~= (3.3437893064688684, 1.3928099822602134, 0.42841463347740269) within 3.34e-11

// The same surface with its parameters found: first along u, then from the control points that this gave.
surface found = interpolate(transpose(rows), second_pass = "control")
check found(1/2, 1/2) ~= (1.7063437477480165, 2.0787714320613049, 2.0789295374372297) within 2.08e-11
check found(0.25, 0.7) ~= (0.65703753271595559, 2.0835587933666319, 2.8663008114472729) within 2.87e-11
check found(0.9, 0.1) ~= (3.3437893064688684, 1.3928099822602134, 0.42841463347740269) within 3.34e-11

// With the parameters of the data along v it is another.
surface by_data = interpolate(transpose(rows))
check by_data.knots_u ~= found.knots_u within 1e-15
check not (by_data.knots_v ~= found.knots_v within 1e-9)
check [for i in 0..4: by_data([0, ...at_rows[1..3], 1][i], 0)] ~= rows[0] within 1e-14
