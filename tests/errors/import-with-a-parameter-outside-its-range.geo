import "lib/naca.geo" as a with (thick = 3)
