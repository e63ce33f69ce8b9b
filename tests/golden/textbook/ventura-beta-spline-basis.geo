// Ventura: the basis of the beta-spline, by powers of t in a segment, from the conditions at the joints (p.12-13)
geo 1
fn powers(i, bias, tension) = {
  let ones = [for j in 0..3: if i == j then (1, 0) else (0, 0)]
  [for c in power_coefficients(beta_spline(ones, bias = bias, tension = tension)): c.x]
}
fn basis_of(bias, tension) = [for i in 0..3: powers(i, bias, tension)]
check basis_of(1, 0) ~= [[1/6, -1/2, 1/2, -1/6], [2/3, 0, -1, 1/2], [1/6, 1/2, 1/2, -1/2], [0, 0, 0, 1/6]] within 2e-12
check basis_of(2, 0) ~= [[8/21, -8/7, 8/7, -8/21], [4/7, 6/7, -12/7, 2/3], [1/21, 2/7, 4/7, -1/3], [0, 0, 0, 1/21]] within 2e-12
check basis_of(1, 5) ~= [[2/17, -6/17, 6/17, -2/17], [13/17, 0, -27/17, 16/17], [2/17, 6/17, 21/17, -16/17], [0, 0, 0, 2/17]] within 2e-12
check basis_of(1/2, 3) ~= [[1/33, -1/11, 1/11, -1/33], [8/11, -3/11, -15/11, 31/33], [8/33, 4/11, 14/11, -38/33], [0, 0, 0, 8/33]] within 2e-12
