unit cm
let late = integrate(s => if s < 1cm then 0 else 2mm, 0cm..2cm)
let early = integrate(s => if s < 1cm then 2mm else 0, 0cm..2cm)
print late, early
check late == 20mm^2 and early == 20mm^2
let step = p => if p.x < 0 then 0 else 1mm
print integrate((x, y) => if x < 1cm then 0 else 1mm, [0cm..2cm, 0..1])
print integrate(step, line((-1, 0), (1, 0))), integrate(step, [line((-1, 0), (0, 0)), line((0, 0), (1, 0))])
print integrate(step, region(polyline([(-1, 0), (1, 0), (1, 1), (-1, 1)], closed = true)))
print integrate(step, face(region(polyline([(-1, 0), (1, 0), (1, 1), (-1, 1)], closed = true))))
print integrate(step, plane_patch((-1, 0), (1, 0), (-1, 1)))
print integrate(s => if s < 1 then 0 else 30deg, 0..2)
print integrate(s => if s < 1cm then 0 else 2mm, 0cm..2cm, report = true).integral
// The derivatives of 2mm * b * 1cm by b, and of 2mm * (end - 1cm) by the end.
print gradient(b => integrate(s => if s < 1cm then 0 else 2mm * b, 0cm..2cm), 3)
print gradient(end => integrate(s => if s < 1cm then 0 else 2mm, 0cm..end), 3cm)
let p = (3, 4)
print integrate(s => if s < 1cm then p.x else 1mm, 0cm..2cm), integrate(s => if s < 1cm then 1mm else p.x, 0cm..2cm)
print minimize(x => if x < 1 then 5 else (x - 2)^2 * 1mm, within = 0..5, report = true).value
print solve(u => [u.a - 2mm], start = {a: 1mm}, report = true).residual
