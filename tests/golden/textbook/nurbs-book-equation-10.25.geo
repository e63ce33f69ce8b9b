// The NURBS Book: Frenet frame of a twisted trajectory ((10.25)-(10.26))
geo 1
curve path = bezier((0, 0, 0), (2, 0, 1), (2, 3, 2), (0, 3, 4))
check tangent(path, 0) ~= (0.89442719099991588, 0, 0.44721359549995794) within 1e-12
check normal(path, 0) ~= (-0.12777531299998798, 0.95831484749990987, 0.25555062599997597) within 1e-12
check binormal(path, 0) ~= (-3/7, -2/7, 6/7) within 1e-12
check tangent(path, 1/3) ~= (0.35856858280031809, 0.71713716560063618, 0.59761430466719682) within 1e-12
check normal(path, 1/3) ~= (-0.91982414555854919, 0.3806168878173307, 0.095154221954332675) within 1e-12
check binormal(path, 1/3) ~= (-0.15922346773028258, -0.58381938167770279, 0.7961173386514129) within 1e-12
check tangent(path, 1/2) ~= (0, 0.76822127959737584, 0.64018439966447987) within 1e-12
check normal(path, 1/2) ~= (-0.98205238020706193, -0.12074414510742565, 0.14489297412891078) within 1e-12
check binormal(path, 1/2) ~= (0.18860838403857944, -0.62869461346193148, 0.75443353615431777) within 1e-12
check tangent(path, 1) ~= (-0.70710678118654752, 0, 0.70710678118654752) within 1e-12
check normal(path, 1) ~= (-0.16222142113076254, -0.97332852678457523, -0.16222142113076254) within 1e-12
check binormal(path, 1) ~= (0.6882472016116853, -0.22941573387056177, 0.6882472016116853) within 1e-12
curve flipping = bezier((0, 0, 0), (1, 2, 0), (2, -2, 0), (3, 0, 0))
check binormal(flipping, 1/4) ~= (0, 0, -1) within 1e-12
check binormal(flipping, 3/4) ~= (0, 0, 1) within 1e-12
check curvature(flipping, 1/2) ~= 0 within 1e-12
