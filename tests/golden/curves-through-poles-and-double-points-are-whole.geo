// Viviani's curve crosses itself where the pole of the ball lies; the circles of Villarceau cross
// where the plane touches the torus twice.
geo 1

surface ball = rotate(sphere((0, 0, 0), 2), 40deg, axis = (1, 0, 0))
surface drill = rotate(cylinder((1, 0, -4), 1, 8), 40deg, axis = (1, 0, 0))
let viviani = intersect(ball, drill)
// 8 sqrt(2) E(1/2), of the elliptic integral of the second kind.
check sum([for c in viviani: length(c)]) ~= 15.2807911151 within 1e-5
check every(viviani, c => every(sample(c, 50), p => abs(norm(p) - 2) <= 1e-6))

let villarceau = section(torus((0, 0, 0), 3, 1), plane((0, 0, 0), (0, -1, sqrt(8))))
check sum([for c in villarceau: length(c)]) ~= 12 * pi within 1e-4
check every(villarceau, c => every(sample(c, 50), p => abs(sqrt(p.x^2 + (abs(sqrt(p.x^2 + p.y^2) - 3))^2 - p.x^2 + p.z^2) - 1) <= 1e-6))
