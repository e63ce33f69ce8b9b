// A cylinder of radius r and height 5: its area is 2 pi r^2 + 10 pi r, of a quarter pi r^2/2 + 5 pi r/2 + 10 r with r^2
// + 5 r for each radian; the centre of a part by the angle a lies at 2/3 r sin(a)/a and 2/3 r (1 - cos(a))/a.
fn profile(r) = region(polyline([(0, 0, 0), (r, 0, 0), (r, 0, 5), (0, 0, 5)], closed = true))
check gradient(r => area(revolve(profile(r))), 2) ~= 18 * pi within 1e-10
check gradient(r => area(revolve(profile(r), angle = 90deg)), 2) ~= 4.5 * pi + 10 within 1e-10
check gradient(a => area(revolve(profile(2), angle = a)), 90deg) * 1rad ~= 14 within 1e-10
check gradient(a => area(revolve(profile(2), angle = a)), -90deg) * 1rad ~= -14 within 1e-10
check gradient(r => centroid(revolve(profile(r), angle = 90deg)).x, 2) ~= 4 / (3 * pi) within 1e-10
check gradient(r => centroid(revolve(profile(r), angle = 90deg)).y, 2) ~= 4 / (3 * pi) within 1e-10
check gradient(r => centroid(revolve(profile(r), angle = -90deg)).y, 2) ~= -4 / (3 * pi) within 1e-10
check gradient(a => centroid(revolve(profile(2), angle = a)).x, 90deg) * 1rad ~= -16 / (3 * pi^2) within 1e-10
check gradient(a => centroid(revolve(profile(2), angle = a)).z, 90deg) * 1rad ~= 0 within 1e-10
// A torus has the area 4 pi^2 times both radii.
check gradient(x => area(revolve(region(circle((x, 0), 1)), axis = (0, 1, 0))), 3) ~= 4 * pi^2 within 1e-9
check gradient(r => area(revolve(region(circle((3, 0), r)), axis = (0, 1, 0))), 1) ~= 12 * pi^2 within 1e-9
fn wedge(u) = revolve(region(polyline([(1, 0, 0), (u.r, 0, 1), (2, 0, u.h)], closed = true)), angle = u.a, about = (0.2, 0, 0))
let sizes = {r: 4, h: 3, a: 130deg}
fn is_like(f) = {
    let [exact, beside] = [gradient(f, sizes), gradient(f, sizes, differences = true)]
    abs(exact.r - beside.r) + abs(exact.h - beside.h) + abs((exact.a - beside.a) * 1rad) < 1e-6
}
check is_like(u => area(wedge(u)) / 1mm^2)
check is_like(u => centroid(wedge(u)).x)
check is_like(u => centroid(wedge(u)).y)
check is_like(u => centroid(wedge(u)).z)
// About its axis a cylinder has pi r^4 h/2, a torus pi^2 R r^2 (4 R^2 + 3 r^2)/2; what moves as what turns.
check gradient(r => inertia(revolve(profile(r))).tensor[2][2], 2) ~= 80 * pi within 1e-8
check gradient(x => inertia(revolve(region(circle((x, 0), 1)), axis = (0, 1, 0))).tensor[1][1], 3) ~= 55.5 * pi^2 within 1e-7
fn turned(u) = revolve(region(polyline([(1, 0, 0), (u.r, 0, 1), (2, 0, u.h)], closed = true)), angle = -130deg, about = (0.2, 0, 0))
fn moved(u) = extrude(region(polyline([(1, 0, 0), (u.r, 0, 1), (2, u.a / 130deg, u.h)], closed = true)), (0.3, u.r, u.h))
fn mixed(t) = (t[0][0] + 2 * t[0][1] - 3 * t[1][2] + 4 * t[1][1] - t[0][2]) / 1000mm^5
check is_like(u => mixed(inertia(turned(u)).tensor))
check is_like(u => mixed(inertia(moved(u)).tensor))
