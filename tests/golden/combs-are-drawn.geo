// A record of geometry goes into a file member by member.
let comb = curvature_comb(bezier((0, 0), (1, 2), (3, 2)), samples = 3)
export comb to "comb.svg" with (decimals = 4)
