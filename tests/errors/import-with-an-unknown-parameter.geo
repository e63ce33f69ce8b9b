import "lib/naca.geo" as a with (tick = 1)
