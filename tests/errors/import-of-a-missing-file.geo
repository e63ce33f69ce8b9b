import "nope.geo" as n
print n.x
