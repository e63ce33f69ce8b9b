// The NURBS Book: Rational skinning: weights after v-interpolation, one becomes negative (Sec 10.3, Fig 10.10)
geo 1
let weights = [[1, 2, 1, 1, 1], [1, 1, 1, 3, 1], [1, 1, 1, 1, 1], [1, 4, 1, 2, 1]]
let sections = [for k in 0..3: nurbs([for i in 0..4: (i, i % 2, k)], weights = weights[k], degree = 3)]
surface s = skin(sections, degree = 2, parameters = [0, 0.30645, 0.59193, 1], align = false)
check transpose(s.weights) ~= [
    [1, 2, 1, 1, 1],
    [1, 396276264709912/420654797798105, 1, 454618733443145569/102639770662737620, 1],
    [1, 1856351814077144/2621002970895885, 1, -480128288001439147/639524724898595940, 1],
    [1, 4, 1, 2, 1],
] within 1e-9
