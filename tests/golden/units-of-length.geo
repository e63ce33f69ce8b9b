unit mm
print 1mm, 1cm, 1m, 1in, 2mm * 3mm, 1/5mm, 10mm + 3
check 1cm == 10mm
check 1m == 1000mm
check 1km == 1000m
check 1um == 0.001mm
check 1in == 25.4mm
check 1ft == 12in
check 10mm + 3 == 13mm "a bare number counts as document units"
check 13mm == 13
check 2mm * 3mm == 6
check (2mm)^3 == 8
check 10mm / 4mm == 2.5
check sqrt(16mm * 1mm) == 4mm
check hypot(3mm, 4mm) == 5mm
let p = (1cm, 1in, 0)
check p == (10, 25.4, 0)
check circle((0, 0), 1cm).start == (10, 0)
