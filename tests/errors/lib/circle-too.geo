import "circle.geo" as other
