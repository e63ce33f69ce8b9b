import "circle-too.geo" as other
