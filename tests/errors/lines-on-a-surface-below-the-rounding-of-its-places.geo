// A sphere of 10 m that is 6 km away: its places are rounded by more than the tolerance.
unit m
tolerance 1e-12

let far = sphere((5000, 3000, 0), 10)
let cut = section(far, plane((5000, 3000, 1), (0, 0.1, 1)))
let heights = contours(far, (0, 0, 1), [3])
let shades = isophotes(far, (0, 0, 1), [60deg])
let mirrored = reflection_lines(far, (4980, 3000, 50), [line((4970, 3000, 60), (4970, 3001, 60))])
let crossed = intersect(far, sphere((5005, 3000, 0), 10))
let large = section(bilinear((1e155, 0, 0), (0, 0, 0), (1e155, 1e155, 0), (0, 1e155, 3e154)), plane((0, 0, 1e154), (0, 0, 1)))
