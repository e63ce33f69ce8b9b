// Warnings of surfaces that turn and swing.
surface turned = revolve(polyline([(-1, 0, 0), (2, 0, 1)]))
surface swung_across = swung(polyline([(-1, 0, 0), (2, 0, 1)]), circle((0, 0), 1))
surface swung_along = swung(
    polyline([(1, 0, 0), (0, 0, 1), (0, 0, 2), (1, 0, 3)]),
    circle((0, 0), 1),
)
surface swung_through = swung(line((1, 0, 0), (2, 0, 1)), line((-1, 0), (3, 0)))
print swung_through(0, 0.25)
