// --set neck=15mm --set tilt=0.25turn --set n=7 --set finish=matt --set closed=true
param neck = 13mm in 8mm..20mm step 0.5mm "Neck radius"
param tilt = 30deg
param n: integer = 5 in 3..31
param finish = "gloss" in ["gloss", "matt"]
param closed = false
param untouched = 2.5
param size: length = 4 "a bare number becomes a length"
print neck, tilt, n, finish, closed, untouched, size
check neck == 15mm
check tilt == 90deg
check n == 7
check finish == "matt"
check closed
check untouched == 2.5
