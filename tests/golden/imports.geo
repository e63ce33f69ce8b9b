// A file's definitions are imported under a name, listed, or under the file's own name; its effects
// do not run, its parameters can be given, and its paths are relative to itself.
geo 1
import "lib/naca.geo" as thick with (thick = 0.2)
import "lib/naca.geo" (foil, twice)
import "lib/util.geo"
check thick.thick == 0.2
check thick.foil(2) == 5 "0.2 * 2 * 10 + 2 / 2"
check foil(2) == 3 "with the file's own default"
check twice(3) == 6
check util.k == 10
print thick.data, thick
