// The NURBS Book: Projection normal method, open and closed ((10.27))
geo 1
curve path = bezier((0, 0, 0), (2, 0, 1), (2, 3, 2), (0, 3, 4))
let first_normal = unit_vector((-1, 0, 2))
fn carry(b, axis) = unit_vector(b - dot(b, axis)*axis)
fn normal_at(i) = if i == 0 then first_normal else carry(normal_at(i - 1), tangent(path, i/4))
curve loop = parametric(t => (3*cos(t), 2*sin(t), sin(2*t)), 0..2*pi)
fn along(i) = tangent(loop, i*pi/4)
fn forward(i) = if i == 0 then (1, 0, 0) else carry(forward(i - 1), along(i))
fn backward(i) = if i == 8 then (1, 0, 0) else carry(backward(i + 1), along(i))
fn both(i) = if i == 0 or i == 8 then (1, 0, 0) else unit_vector(forward(i) + backward(i))
check normal_at(0) ~= (-0.44721359549995794, 0, 0.89442719099991588) within 1e-12
check normal_at(1) ~= (-0.61895123549764063, -0.17332774442630559, 0.76606583339033827) within 1e-12
check normal_at(2) ~= (-0.66268769270283519, -0.47943145202270945, 0.57531774242725134) within 1e-12
check normal_at(3) ~= (-0.50509286866100119, -0.82055151919108915, 0.26753765787454343) within 1e-12
check normal_at(4) ~= (-0.14181240315493404, -0.97968284899902423, -0.14181240315493404) within 1e-12
check both(0) ~= (1, 0, 0) within 1e-12
check both(1) ~= (0.52517425493421943, 0.78776138240132915, -0.32190682868096223) within 1e-12
check both(2) ~= (0.30756321362144023, 0.83220539909764468, -0.46134482043216034) within 1e-12
check both(3) ~= (-0.42958798996210529, 0.64438198494315794, -0.63263418842253056) within 1e-12
check both(4) ~= (-1, 0, 0) within 1e-12
check both(5) ~= (-0.42958798996210529, -0.64438198494315794, 0.63263418842253056) within 1e-12
check both(6) ~= (0.30756321362144023, -0.83220539909764468, 0.46134482043216034) within 1e-12
check both(7) ~= (0.52517425493421943, -0.78776138240132915, 0.32190682868096223) within 1e-12
check both(8) ~= (1, 0, 0) within 1e-12
