// Isophotes, mirrored stripes and mirrored lights, by closed forms.

let ball = sphere((1, 2, 3), 5)

// On a sphere the isophote of an angle is a circle about the light.
curves circles = isophotes(ball, (1, 2, 2), [30deg, 90deg, 120deg])
check [for c in circles: length(c)] ~= [5*pi, 10*pi, 5*sqrt(3)*pi] within 1e-5
check every(sample(circles[0], 20), p => dot(p - (1, 2, 3), (1, 2, 2)/3) ~= 5*cos(30deg) within 1e-5)
// Around a cylinder they are its lines; where it faces the light it touches the angle of 0deg.
print [for a in [0deg, 60deg, 90deg]: len(isophotes(cylinder((0, 0), 5, 2), (1, 0, 0), [a]))]
// A plane has one angle: told by its border, or none.
print [for c in isophotes(plane_patch((0, 0), (2, 0), (0, 3)), (0, 0, 7), [0deg, 30deg]): length(c)]
print [for c in isophotes(plane_patch((0, 0), (2, 0), (0, 3)), (0, sin(30deg), cos(30deg)), [30deg]): length(c)]

// A ray that comes to a cylinder at the angle a from its normal leaves at 2a: of n stripes all around
// 2n borders are mirrored, the first at half of a half of a stripe.
curves stripes = zebra(cylinder((0, 0), 1, 2), (1, 0, 0), bands = 8)
print len(stripes)
check every(stripes, c => is_straight(c))
check any(stripes, c => c.start.x ~= cos(11.25deg) and c.start.y ~= sin(11.25deg))
// Zebra is no isophote: stripes of a sphere are no circles.
check not any(zebra(ball, (0, 0, 1), bands = 4), c => is_planar(c) and c.closed)
print zebra(plane_patch((0, 0), (2, 0), (0, 3)), (0, 0, 1))

// A flat mirror shows a light that is as high as the eye half way, and none below it.
curves seen = reflection_lines(plane_patch((0, 0), (4, 0), (0, 4)), (0, 2, 1), [line((4, 0, 1), (4, 4, 1)), line((4, 0, -1), (4, 4, -1))])
check len(seen) == 1
check every(sample(seen[0], 5), p => p.x ~= 2)
// In a sphere seen from afar a light along z behind the eye lies in the plane of both.
check every(reflection_lines(sphere((0, 0), 1), (9, 0, 0), [line((20, 0, -1), (20, 0, 1))]), c => every(sample(c, 9), p => p.y ~= 0 within 1e-6))
