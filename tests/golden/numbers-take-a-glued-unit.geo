unit m
print 12, 1_000, 0.5, 1e-3, 2.5e3mm, 1_000um, 30deg, 0.5turn, 1rad
check 1um + 1mm + 1cm + 1m + 1km == 1001.011001
check 1in == 0.0254 and 1ft == 12in
check 1turn == 360deg and 180deg ~= pi * 1rad
check 3 * 2mm == 6mm "a unit binds tighter than any operator"
check 2mm^2 == 2 * 1mm * 1mm "and a power behind it is its own"
check (2mm)^2 == 4mm^2 and 1 / 2mm == 0.5mm^-1 and 9mm^(1/2) == 9 * sqrt(1mm)
