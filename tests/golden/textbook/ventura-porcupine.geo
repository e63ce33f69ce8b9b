// Ventura: Porcupine: vectors of length kappa on the side opposite to the centre of curvature (p.23)
geo 1
curve c = bezier((0, 0), (1, 2), (3, 2), (4, 0))
let comb = curvature_comb(c, samples = 5, scale = 1)
check curvature(c, 0) ~= 0.23851391759997757 within 1e-12
check comb.teeth[0].end ~= (-0.21333333333333333, 0.10666666666666667, 0) within 1e-12
check comb.teeth[0].start ~= c(0) within 1e-11
check curvature(c, 1/4) ~= 0.44086383105012472 within 1e-12
check comb.teeth[1].end ~= (0.6469463720477234, 1.4815424884343803, 0) within 1.48e-12
check comb.teeth[1].start ~= c(1/4) within 1e-11
check curvature(c, 1/2) ~= 16/27 within 1e-12
check comb.teeth[2].end ~= (2, 113/54, 0) within 2.09e-12
check comb.teeth[2].start ~= c(1/2) within 1e-11
check curvature(c, 1) ~= 0.23851391759997757 within 1e-12
check comb.teeth[4].end ~= (4.2133333333333333, 0.10666666666666667, 0) within 4.21e-12
check comb.teeth[4].start ~= c(1) within 1e-11
