// The NURBS Book: Sweep with a fixed plane normal B=(0,0,1) and scaling: exact points of T+A S C ((10.20)-(10.24))
geo 1
curve path = bspline([(0, 0, 0), (2, 0, 0), (4, 2, 0), (4, 5, 0), (7, 6, 0)], degree = 3, knots = [0, 0, 0, 0, 0.5, 1, 1, 1, 1])
curve profile = bezier((0, -1, 0), (0, 0, 1), (0, 1, 0))
fn upright(v) = (0, 0, 1)
curve scaling = bspline([(0.3, 0.3, 1), (1.5, 1.5, 0.5), (0.3, 0.3, 1), (1, 1, 2)], degree = 1, knots = [0, 0, 3/10, 7/10, 1, 1])
fn placed(v, q) = {
  let x = tangent(path, v)
  let z = upright(v)
  path(v) + q.x*x + q.y*cross(z, x) + q.z*z
}
fn swept(u, v) = placed(v, (scaling(v).x*profile(u).x, scaling(v).y*profile(u).y, scaling(v).z*profile(u).z))
check [placed(0, (1, 0, 0)) - path(0), placed(0, (0, 1, 0)) - path(0), placed(0, (0, 0, 1)) - path(0)] ~= [(1, 0, 0), (0, 1, 0), (0, 0, 1)] within 1e-12
check swept(0, 0) ~= (0, -3/10, 0) within 1e-12
check [placed(0.3, (1, 0, 0)) - path(0.3), placed(0.3, (0, 1, 0)) - path(0.3), placed(0.3, (0, 0, 1)) - path(0.3)] ~= [(0.72536892907952872, 0.68836031024894052, 0), (-0.68836031024894052, 0.72536892907952872, 0), (0, 0, 1)] within 1e-12
check swept(1/2, 0.3) ~= (2.628, 0.918, 0.25) within 2.63e-12
check [placed(1/2, (1, 0, 0)) - path(1/2), placed(1/2, (0, 1, 0)) - path(1/2), placed(1/2, (0, 0, 1)) - path(1/2)] ~= [(0.37139067635410373, 0.92847669088525932, 0), (-0.92847669088525932, 0.37139067635410373, 0), (0, 0, 1)] within 1e-12
check swept(1/4, 1/2) ~= (3.9178145108983667, 2.0828741956406533, 0.28125) within 3.92e-12
check [placed(1, (1, 0, 0)) - path(1), placed(1, (0, 1, 0)) - path(1), placed(1, (0, 0, 1)) - path(1)] ~= [(0.9486832980505138, 0.31622776601683793, 0), (-0.31622776601683793, 0.9486832980505138, 0), (0, 0, 1)] within 1e-12
check swept(1, 1) ~= (6.6837722339831621, 6.9486832980505138, 0) within 6.95e-12
check path(1/3) ~= (76/27, 10/9, 0) within 2.81e-12
