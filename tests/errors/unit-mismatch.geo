let a = 10mm + 30deg
let b = 10mm < 30deg
let c = 2mm * 3mm + 1mm
let d = sin(10mm)
