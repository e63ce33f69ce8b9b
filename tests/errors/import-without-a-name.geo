import "lib/not-a-name.geo"
