// Linkeová: Ellipse: Frenet trihedron and planes (Example 1.3 / Fig 1.4)
geo 1
curve c = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check tangent(c, 0) ~= (0, 1, 0) within 1e-12
check normal(c, 0) ~= (-1, 0, 0) within 1e-12
check binormal(c, 0) ~= (0, 0, 1) within 1e-12
check tangent(c, pi/3) ~= (-0.91766293548224706, 0.39735970711951314, 0) within 1e-12
check normal(c, pi/3) ~= (-0.39735970711951314, -0.91766293548224706, 0) within 1e-12
check binormal(c, pi/3) ~= (0, 0, 1) within 1e-12
check tangent(c, 2*pi/3) ~= (-0.91766293548224706, -0.39735970711951314, 0) within 1e-12
check normal(c, 2*pi/3) ~= (0.39735970711951314, -0.91766293548224706, 0) within 1e-12
check binormal(c, 2*pi/3) ~= (0, 0, 1) within 1e-12
check tangent(c, 3*pi/3) ~= (0, -1, 0) within 1e-12
check normal(c, 3*pi/3) ~= (1, 0, 0) within 1e-12
check binormal(c, 3*pi/3) ~= (0, 0, 1) within 1e-12
check tangent(c, 4*pi/3) ~= (0.91766293548224706, -0.39735970711951314, 0) within 1e-12
check normal(c, 4*pi/3) ~= (0.39735970711951314, 0.91766293548224706, 0) within 1e-12
check binormal(c, 4*pi/3) ~= (0, 0, 1) within 1e-12
check tangent(c, 5*pi/3) ~= (0.91766293548224706, 0.39735970711951314, 0) within 1e-12
check normal(c, 5*pi/3) ~= (-0.39735970711951314, 0.91766293548224706, 0) within 1e-12
check binormal(c, 5*pi/3) ~= (0, 0, 1) within 1e-12
check tangent(c, 6*pi/3) ~= (0, 1, 0) within 1e-12
check normal(c, 6*pi/3) ~= (-1, 0, 0) within 1e-12
check binormal(c, 6*pi/3) ~= (0, 0, 1) within 1e-12
check normal_plane(c, 2*pi/3).origin ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check norm(cross(normal_plane(c, 2*pi/3).z, (-0.91766293548224706, -0.39735970711951314, 0))) ~= 0 within 1e-11
check rectifying_plane(c, 2*pi/3).origin ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check norm(cross(rectifying_plane(c, 2*pi/3).z, (0.39735970711951314, -0.91766293548224706, 0))) ~= 0 within 1e-11
check osculating_plane(c, 2*pi/3).origin ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check norm(cross(osculating_plane(c, 2*pi/3).z, (0, 0, 1))) ~= 0 within 1e-11
