import "lib/wrong.geo"
print wrong.y
