import "util.geo"
param thick = 0.1 in 0..0.5
fn foil(x) = thick * x * util.k + _half(x)
fn _half(x) = x / 2
fn twice(x) = 2 * x
let data = load("d.json").v
print "never"
