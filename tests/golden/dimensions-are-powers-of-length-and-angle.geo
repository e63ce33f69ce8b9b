print 2mm * 3mm, (2mm)^3, 1 / 4mm, sqrt(3mm^2), 90deg / 2, 90deg / 30deg, 10mm % 3mm
check 2mm * 3mm == 6mm * 1mm
check (2mm * 2mm * 2mm)^(1/3) ~= 2mm and cbrt(8mm * 1mm * 1mm) == 2mm "a root of a volume is a length"
check 1/5mm > 1/6mm
check 6mm / 2mm == 3 "their ratio is a plain number"
check hypot(3mm, 4mm) + 1mm == 6mm
check abs(-2mm) == 2mm and max(1mm, 2mm) == 2mm
check 10deg * 3 == 30deg and -(10deg) == -10deg
check [1mm, 2mm] == [1, 2] "a bare number fits anywhere"
check (1cm, 2mm).x == 10mm
