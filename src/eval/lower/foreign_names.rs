//! Words that people bring along from other languages and programs, and what to write here.

/// Words, in lower case and without `_`, and what to write instead of each.
const FOREIGN: &[(&[&str], &str)] = &[
    (&["null", "nil", "undef", "undefined", "none"], "the empty value is written `none`"),
    (&["true"], "write `true`"),
    (&["false"], "write `false`"),
    (&["pi", "mpi"], "write `pi`"),
    (&["math", "np", "numpy"], "functions and constants stand alone: `sqrt(2)`, `pi`"),
    (&["var", "const", "set"], "definitions begin with `let`"),
    (&["function", "def", "func", "module"], "functions are defined as `fn name(a, b) = ...`"),
    (&["lambda"], "a function without a name is written `x => x^2`"),
    (&["return"], "a function is one expression: `fn f(x) = x^2`"),
    (&["echo"], "write `print`, a statement of its own"),
    (&["read", "open", "readcsv"], "write `load(\"points.csv\")`"),
    (&["isocurve", "isocurves", "isoline"], ISOCURVE),
    (&["umbilic", "umbilics"], "`describe(s).umbilics` lists the umbilics of a surface"),
    (&["merge"], "`join` makes one curve of curves, and one surface of patches"),
    (&["subtract", "boolean"], NO_SOLIDS),
    (
        &["color", "colour", "material"],
        "a definition has a colour: `curve c = ... with (color = \"red\")`",
    ),
    (&["move", "moved", "shift"], "write `translate(g, vector)`"),
    (&["rotated", "turn"], "write `rotate(g, angle)`"),
    (&["mirrored", "reflect", "flipped"], "write `mirror(g, plane)`"),
    (&["resize", "scaled", "scale1d"], "write `scale(g, factor)`"),
    (&["multmatrix", "affine"], "write `transform(...)`; `virote doc transform` tells how"),
    (&["cube", "cuboid", "makebox"], "write `box(corner, size)`"),
    (&["linearextrude", "extrudecrv"], "write `extrude(curve, vector)`"),
    (&["rotateextrude", "lathe", "revsrf", "surfaceofrevolution"], "write `revolve(curve)`"),
    (
        &["polygon", "ngon", "regularpolygon", "square", "rectangle", "rect"],
        "write `polyline(corners, closed = true)`, and `region(...)` of it for what is inside",
    ),
    (&["loftsrf", "multisection", "blendsurface"], "write `skin([a, b, c])`"),
    (&["sweep1", "sweep2", "pipe"], "write `sweep(section, path)`"),
    (&["networksrf", "curvenetwork"], "write `gordon(u, v)`"),
    (&["edgesrf", "patch"], "write `coons(u, v)`"),
    (&["planar", "planarsrf", "makeface", "face"], "write `planar_mesh(curve)`"),
    (
        &["bsplinecurve", "nurbscurve"],
        "write `bspline(points)`, or `nurbs(points, ...)` with weights",
    ),
    (&["spline", "interpcrv", "interpolatecurve", "makespline"], "write `interpolate(points)`"),
    (&["approximatecurve", "fitcrv", "rebuild"], "write `approximate(points, ...)`"),
    (
        &["centerarc", "makecircle"],
        "write `arc(center, radius, from, to)`, or `circle(center, radius)`",
    ),
    (&["threepointarc", "arc3pt"], "write `arc_through(a, b, c)`"),
    (&["dividecurve", "dividelength"], "write `divide(curve, n)`"),
    (
        &["curveclosestpoint", "surfaceclosestpoint", "crvcp", "pullpoint"],
        "write `closest(g, point)`",
    ),
    (
        &["evaluatecurve", "evaluatesurface", "evaluatesingle", "evalcrv"],
        "a curve is called as `c(t)`, a surface as `s(u, v)`",
    ),
    (&["curvelength", "lengthcurve", "arclength"], "write `length(curve)`"),
    (&["findctrlpts", "ctrlpts", "controlpoints", "poles"], "write `c.points`"),
    (&["splitcurve", "shatter"], "write `split(curve, t)`"),
    (&["offsetcrv", "offset2d", "offsetsrf"], "write `offset(g, distance)`"),
    (&["concat", "append"], "write `flatten([a, b])`"),
    (&["degrees", "todeg", "rad2deg"], "an angle divided by `1deg` is a number of degrees"),
    (&["radians", "torad", "deg2rad"], "a number of degrees becomes an angle by `* 1deg`"),
    (
        &["deg", "rad", "mm", "cm", "inch"],
        "a unit is glued to its number: `90deg`; a computed number takes it by `* 1deg`",
    ),
    (
        &["chamfer", "filletcurves"],
        "`fillet(r, radius)` rounds the corners of a region; arcs between curves are made by `arc` and put together by `join`",
    ),
    (&["pow", "power"], "a power is written `a^b`"),
    (&["mod", "fmod"], "a remainder is written `a % b`"),
    (&["int", "trunc"], "write `floor(x)` or `round(x)`"),
    (&["float", "double"], "all numbers are of one kind; `num(text)` reads one from a text"),
    (&["arange"], "write `range(a, b, step)`, or `[for i in 0..<n: ...]`"),
    (&["enumerate"], "write `[for i in 0..<len(xs): (i, xs[i])]`"),
    (&["crossproduct"], "write `cross(a, b)`"),
    (&["dotproduct", "inner"], "write `dot(a, b)`"),
    (&["normalize", "normalise", "unitize", "normalized"], "write `unit_vector(v)`"),
    (&["vec3", "vec", "vector", "point3d", "vector3"], "a point or vector is written `(x, y, z)`"),
];

const ISOCURVE: &str =
    "an isocurve is the surface with one parameter left out: `s(0.5, _)` or `s(_, 0.5)`";
const NO_SOLIDS: &str = "plane regions are combined by `union`, `intersection` and `difference`; surfaces are not, `intersect(a, b)` tells where two of them cross";

/// What to write instead of `name`, when it is the habit of another language or program.
pub(crate) fn advice(name: &str) -> Option<&'static str> {
    let plain = name.replace('_', "").to_lowercase();
    let row = FOREIGN.iter().find(|(words, _)| words.contains(&plain.as_str()));
    row.map(|&(_, advice)| advice)
}

/// The word that takes the place of `name`, where it is that word written otherwise.
pub(crate) fn word(name: &str) -> Option<&'static str> {
    let words = ["true", "false", "none", "pi"];
    match name {
        "null" | "nil" | "undef" | "undefined" => Some("none"),
        _ => words.into_iter().find(|word| name.eq_ignore_ascii_case(word)),
    }
}
