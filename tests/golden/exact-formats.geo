// Exact curves and surfaces as STEP, IGES, DXF and OBJ hold them.
unit in
tolerance 1e-5
curve arch = nurbs((0, 0), (1, 1), (2, 0), weights = [1, 0.5, 1], degree = 2) with (color = "#ff0000", layer = "lines")
surface roof = bilinear((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0.125)) with (color = "#0000ff", layer = "roofs")
point peak = (0.5, -0.25, 3)
export arch to "arch.step"
export roof to "roof.stp"
export arch, roof, peak to "all.igs"
export arch, peak to "arch.dxf"
export arch, roof, peak to "all.obj" with (free_form = true)
