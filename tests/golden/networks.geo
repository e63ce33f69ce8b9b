// Networks of curves, and what is done so that they make a surface.
// Two and two curves: the Coons patch.
let c = [bezier((0, 0, 0), (1, 0, 2), (2, 0, 1), (4, 0, 0)), bezier((0, 3, 1), (2, 4, 0), (4, 3, 0))]
let d = [bezier((0, 0, 0), (0, 1, 1), (0, 2, 3), (0, 3, 1)), bezier((4, 0, 0), (5, 1, 1), (4, 3, 0))]
surface patch = gordon(u = c, v = d)
check patch(1/2, 1/2) ~= (2.0625, 1.625, 1.5) within 1e-14
check derivative(patch, 1/3, 3/4, du = 1, dv = 0) ~= (4.20833333333333333, 0.3125, -1.453125) within 1e-13
// The same from curves in any direction and order: the first of each list gives direction and order.
surface again = gordon(u = [c[0], reversed(c[1])], v = [reversed(d[1]), d[0]])
check again(1/3, 1/4) ~= patch(1/3, 3/4) within 1e-14
print report(again)

// Vukašinović & Duhovnik, (1.47) to (1.52): one polynomial in each direction.
let at = [[0, 1/3, 1], [0, 1/2, 1]]
surface bent = gordon(
  u = [for v in at[1]: parametric(u => (u, v, sin(3*u*1rad) + u*v), 0..1)],
  v = [for u in at[0]: parametric(v => (u, v, sin(3*u*1rad) + u*v), 0..1)],
  blend = "lagrange", tolerance = 1e-9,
)
check bent(1/5, 1/2) ~= (1/5, 1/2, 0.664642473395035357) within 2e-9
check bent(1/5, 2/7) ~= (1/5, 2/7, 0.621785330537892501) within 2e-9
check bent(3/4, 9/10) ~= (3/4, 9/10, 1.45307319688792124) within 2e-9

// What stands out is cut off; rational curves become splines within the tolerance; a ring closes.
fn guide(k) = rotate(interpolate([(0.9, 0, -1), (1, 0, 0), (1.1, 0, 1), (1.4, 0, 2), (1.9, 0, 3), (2.5, 0, 4)]), 90deg*k)
surface tube = gordon(u = [for z in 0..3: circle((0, 0, z), 1 + z*z/10)], v = [for k in 0..3: guide(k)])
check report(tube).deviation <= 1e-6
check every([for u in linspace(0, 1, 17): abs(hypot(tube(u, tube.domain_v.start).x, tube(u, tube.domain_v.start).y) - 1) < 1e-6])
check report(tube).seam_u < 0.001deg
print [for change in report(tube).v: change.trimmed], [for change in report(tube).u: change.refitted]
