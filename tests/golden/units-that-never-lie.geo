// Questions answer with their dimension, and what is printed says its unit.
unit m
surface cube = box((0, 0, 0), (2, 2, 2))[0]
let hull = box((0, 0, 0), (2, 2, 2))
curve arch = arc((0, 0), 4, 0deg, 90deg)
print volume(hull), area(hull), length(arch), curvature(arch, 0.5), gaussian(sphere((0, 0), 2), 1, 0.5)
print distance((0, 0), (3, 4)), radius_of_curvature(arch, 0), closest(arch, (0, 0)).distance, angle_between((1, 0), (0, 1))
check volume(hull) / area(hull) + 1m == 4/3 * 1m and sqrt(area(hull)) > 4m and volume(hull) == 8m^3

// What is known of none and of known numbers is known; what is open stays open, and is told without a unit.
let p = (3, 4)
print 2 * 3m, 3 / 2m, p.x * 3m, p.x + 3m, norm(p) * 1m, p.x * 20deg, atan2(p.y, p.x)
check p.x + 1m == 4 and circle((0, 0), p.x * p.y).closed and p.x == 3m and 3 < 4m
check max(p.x, 1m) == 3 and sum([p.x, 1m, 2]) == 6 and hypot(p.x, p.y) == 5m

// A product of coordinates and lengths goes into a table without a unit.
let moments = table({area: [for q in [(1, 2), (3, 4)]: q.x * 2m], length: [for n in 1..2: n * 2m]})
print moments
export moments to "moments.csv"

// A power behind a unit is that of the unit; what is printed reads back.
print 5mm^2, (5mm)^2, -5mm^2, 2m^-1, 4m^(1/2), 1m * 2rad, 3rad^2, 5km^2
check 5mm^2 == 5 * 1mm * 1mm and (5mm)^2 == 25mm^2 and 2 ^ 2 == 4 and 2rad^2 / 1rad == 2rad
check "{volume(hull)}" == "8m^3" and str(2m) == "2m" and "{[1m, 2deg]}" == "[1m, 2deg]" and "{volume(hull):.1}" == "8.0m^3"
