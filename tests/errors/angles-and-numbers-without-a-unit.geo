// To an angle only angles are added, and a coordinate is a length or a plain number.
let a = 3 + 0deg
let b = (1, 2).x - 30deg
let c = sum([1, 20deg])
let d = lerp(0, 90deg, 0.5)
let e = (0, area(sphere((0, 0), 1)))
let f = (0, curvature(circle((0, 0), 2), 0), 0)
let g = circle((0, 0), volume(box((0, 0, 0), (1, 1, 1))))
let h = rotate((1, 0), (1, 2).x)
check length(circle((0, 0), 1)) ~= area(sphere((0, 0), 1))
let i = ln(length(line((0, 0), (1, 0))))
let j = 5mm^2 + 5mm
let k = 5mm^(1/7)
// Two may be compared although only one is an angle.
check 0 < 30deg and max(0, 30deg) == 30deg
