unit mm
surface sheet = plane_patch((-2, -2), (4, 0), (0, 4))
solid ball = solid(sphere((0, 0), 1))
check area(trim(sheet, by = ball, keep = "inside")) ~= pi and area(trim(sheet, by = ball, keep = "outside")) ~= 16 - pi
print len(split(sheet, by = ball))
// What is in a void is outside.
solid hollow = solid([sphere((0, 0), 1.5), sphere((0, 0), 1)])
check area(trim(sheet, by = hollow, keep = "inside")) ~= 1.25*pi
check [for f in trim(sheet, by = hollow, keep = "outside"): area(f)] ~= [16 - 2.25*pi, pi]
// Its faces cut together, where they meet as well.
solid bar = solid(box((-0.5, -0.5, -0.5), (3, 1, 1)))
check area(trim(sheet, by = bar, keep = "inside")) ~= 2.5
check area(trim(sphere((0, 0), 1), by = bar, keep = "inside")) ~= integrate((y, z) => 1/sqrt(1 - y^2 - z^2), [-0.5..0.5, -0.5..0.5]) within 1e-8
// With other cutters, and one that misses.
check len(split(sheet, by = [ball, plane((0, 0), (1, 0))])) == 4
check area(trim(sheet, by = translate(bar, (9, 0, 0)), keep = "outside")) ~= 16
