// Vukašinović, Duhovnik: Bicubic B-spline surface interpolation, averaged chord-length parameters, Bessel ends (Tables 1.1-1.5, Fig 1.24-1.25)
geo 1
let rows = [
  [(0, 0, 0), (1, 1, 0), (2, 1, 0), (2.5, 0.5, 0), (4, 2, 0)],
  [(0, 0.5, 2), (0.9, 2.5, 2), (1.8, 2, 2), (2.5, 1.5, 2), (3.7, 2, 2)],
  [(0, 0, 4), (1, 0.8, 4), (2, 1, 4), (3, 0.7, 4), (4, 0, 4)],
]
// the same surface with its parameters found: rows first, then the columns of the control points that they gave
surface found = interpolate(transpose(rows), second_pass = "control")
check found(1/2, 1/2) ~= (1.7063437477480165, 2.0787714320613049, 2.0789295374372297) within 2.08e-12
check found(0.25, 0.7) ~= (0.65703753271595559, 2.0835587933666319, 2.8663008114472729) within 2.87e-12
check found(0.9, 0.1) ~= (3.3437893064688684, 1.3928099822602134, 0.42841463347740269) within 3.34e-12
