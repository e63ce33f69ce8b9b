// Cubics are written exactly, quadratics and lines too; what a surface hides is left out.
curve cubic = bezier((0, 0), (1, 2), (3, 2), (4, 0)) with (color = "#c04020", layer = "lines")
curve parabola = bezier((0, 0, 1), (2, 0, 3), (4, 0, 1)) with (color = "steelblue", layer = "lines")
curve leg = line((0, -1), (4, -1, 2))
curve behind = line((-1, 1, -1), (5, 1, -1))
surface roof = bilinear((1, 0.5, 1), (1, 1.5, 1), (3, 0.5, 1), (3, 1.5, 1)) with (layer = "walls & roofs")
mesh tile = grid_mesh(bilinear((5, 0), (5, 1), (6, 0), (6, 1)), 1, 1)
point peak = (2, 1, 4)
point under = (2, 1, -4)

export cubic, parabola, leg to "top.svg"
export cubic, parabola, leg to "front.svg" with (view = "front")
export cubic, parabola, leg to "right.svg" with (view = "right")
export behind, roof, tile, peak, under to "hidden.svg"
export roof, tile to "isometric.svg" with (view = "isometric", decimals = 3)
export roof, tile to "oblique.svg" with (view = "oblique", decimals = 3)
