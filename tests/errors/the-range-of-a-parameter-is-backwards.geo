param q = 5 in 10..1
param w = 5mm in 10mm..<1mm
