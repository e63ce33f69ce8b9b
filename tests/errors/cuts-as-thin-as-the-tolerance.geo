unit mm
solid can = solid(cylinder((0, 0), 1, 4), cap = true)
print volume(cut(can, plane((1 - 2e-6, 0, 4), (1, 0, -0.5)), keep = "above"))
