curve c = circle((0, 0), 5mm)
check length(c) < 30mm "the wire is long enough"
check c(0.25) ~= (0, 6)
check c.closed
export report to "review.md" with (picture = false)
