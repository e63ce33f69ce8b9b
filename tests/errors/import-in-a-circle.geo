import "lib/circle.geo" as c
