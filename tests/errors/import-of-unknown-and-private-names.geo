import "lib/naca.geo" (foil, foli, _half)
print foil(1)
