print parametric(a => polar(2, a * 1rad), 0deg..360deg)
print max(1, 30deg), max(0, 30deg)
print clamp(1, 0deg, 90deg)
print linspace(10, 90deg, 3)
print range(0deg, 90deg, 30)
print integrate(t => cos(t), 0deg..90)
print floor(400deg)
print round(100deg)
print 5mm2
param tilt = 15deg in 0..90
check 30deg ~= 60deg within 1
check {a: 1mm, b: 30deg} ~= {a: 1.5mm, b: 60deg} within 1mm
check [30deg] ~= [30deg] within 1e-3
let rows = table([{a: 1}, {a: 2}])
check every(rows, f = row => row.a > 0)
