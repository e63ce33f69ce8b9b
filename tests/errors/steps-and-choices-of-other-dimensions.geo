param tilt = 0deg in 0deg..90deg step 15
param width = 5mm in 0mm..20mm step 5deg
param depth = 5mm in 0mm..20mm step 5mm^2
param n: integer = 3 in 1..9 step 2mm
param turn = 30deg in [30deg, 45]
param leg = 3mm in [1deg, 3mm, 2]
param beam = 5mm in 0mm..20mm step 5
param plate = 4mm^2 in 0mm^2..20mm^2 step 2
