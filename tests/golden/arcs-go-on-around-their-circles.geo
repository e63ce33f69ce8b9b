let quarter = arc((0, 0), 1, from = 0deg, to = 90deg)
// A turn and a half beyond, from either end: each point on the circle, and as long as asked for.
curve around = extend(quarter, 3*pi)
check length(around) ~= 3.5*pi within 1e-9
check around.end ~= (0, -1) within 1e-9
check every(linspace(around.domain.start, around.domain.end, 99), t => norm(around(t)) ~= 1 within 1e-12)
curve before = extend(quarter, 3*pi, at = "start")
check before.start ~= (-1, 0) within 1e-9
check length(before) ~= 3.5*pi within 1e-9
// The old part keeps its points and parameters.
check every(linspace(0, 1, 9), t => around(t) ~= quarter(t) within 1e-14 and before(t) ~= quarter(t) within 1e-14)
print around.domain.start, before.domain.end
// So does an arc behind a line.
check extend(join([line((1, -3), (1, 0)), quarter]), 2.5*pi).end ~= (-1, 0) within 1e-9
check length(extend(circle((0, 0), 2), 9*pi)) ~= 13*pi within 1e-9
