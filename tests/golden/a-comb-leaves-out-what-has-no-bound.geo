curve cusp = bezier((0, 0), (1, 1), (0, 1), (1, 0))
let comb = curvature_comb(cusp, samples = 5)
print len(comb.teeth), curvature_table(cusp, samples = 5).curvature[2], curvature_table(cusp, samples = 5).tx[2]
