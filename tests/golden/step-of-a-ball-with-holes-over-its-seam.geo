// The face goes over both poles and its seam, which runs through both holes: the two loops around these bound it.
geo 1

face pierced = trim(sphere((0, 0, 0), 2), by = cylinder((1, 0, -3), 0.5, 6), keep = (-2, 0, 0))
solid flattened = cut(solid(sphere((0, 0, 0), 2)), plane((1.5, 0, 0), (1, 0, 0)))
check volume(flattened) ~= 32 / 3 * pi - pi * 0.25 * (2 - 0.5 / 3) within 1e-6
export [pierced, flattened] to "pierced.step"
