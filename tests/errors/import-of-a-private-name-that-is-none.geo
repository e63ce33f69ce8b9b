import "lib/naca.geo" (foil, _none)
print foil(1)
