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
    (&["subtract", "boolean", "minus"], BOOLEANS),
    (
        &["chop", "slicebyplane", "sliceplane"],
        "write `section(g, plane)`, and `cut(solid, plane)` for what is on one side of it",
    ),
    (&["contour"], "write `contours(s, direction, levels)`"),
    (&["pull"], "write `project(curve, plane)`, or `closest(g, point)`"),
    (
        &["blend", "matchsrf"],
        "a curve that goes on smoothly is `hermite(points, tangents = ...)` or `continue_bezier`; a surface between curves is `skin`, `gordon` or `coons`",
    ),
    (
        &["fill"],
        "write `edge_surface([a, b, c, d])`, or `region(curve)` for what lies within a plane curve",
    ),
    (
        &["shell", "hollow", "thicken"],
        "write `offset(s, distance)`, and `solid([...])` of what encloses",
    ),
    (
        &["hull", "convexhull", "minkowski", "voronoi", "delaunay"],
        "there is no such built-in; regions grow by `offset`, surfaces go through curves by `skin`",
    ),
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
    (
        &["planar", "planarsrf", "makeface", "fillplane"],
        "write `region(curve)`, and `planar_mesh(curve)` for its mesh",
    ),
    (&["ball", "makesphere"], "write `sphere(center, radius)`"),
    (&["prism", "tube"], "write `extrude(curve, vector)`, or `cylinder(center, radius, height)`"),
    (&["segment", "makeline"], "write `line(a, b)`"),
    (&["wire", "path", "polycurve", "compositecurve"], "write `join([a, b, c])`"),
    (
        &["parabola", "hyperbola"],
        "write `conic(a, b, c, weight)`: 1 makes a parabola, more a hyperbola",
    ),
    (
        &[
            "spiral",
            "clothoid",
            "eulerspiral",
            "catenary",
            "superellipse",
            "cycloid",
            "archimedeanspiral",
        ],
        BY_FORMULA,
    ),
    (
        &["naca", "airfoil"],
        "write `parametric` of its formula, or `interpolate` through `load(\"airfoil.csv\")`",
    ),
    (
        &["text", "glyph", "font"],
        "there are no fonts: the outlines of letters are made of curves, and `regions([...])` of them",
    ),
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
    (&["concat", "append", "push", "extendlist", "prepend"], "join lists by `[...a, ...b]`"),
    (&["count", "size", "numelements", "listlength", "nrows"], "write `len(list)`"),
    (&["sorted"], "write `sort(list)`"),
    (&["distinct", "dedupe", "uniq"], "write `unique(list)`"),
    (
        &["foldl", "foldr", "accumulate", "inject"],
        "write `fold(list, start, f)`, or `scan` for all values on the way",
    ),
    (&["cumsum"], "write `scan(list, 0, (sum, x) => sum + x)`"),
    (&["all", "forall"], "write `every(list, test)`"),
    (&["some", "exists"], "write `any(list, test)`"),
    (&["select", "where"], "write `filter(list, test)`"),
    (&["average", "avg"], "write `mean(list)`"),
    (&["prod"], "write `product(list)`"),
    (&["std", "stdev", "variance"], "write it with `mean`, `sum` and `len`"),
    (&["indexof", "find", "search"], "write `index_of(list, value)`, or `filter(list, test)`"),
    (&["includes", "has", "member"], "write `contains(list, value)`"),
    (
        &["slice", "sublist", "take", "drop", "skip"],
        "part of a list is `xs[1..3]`, to its end `xs[1..-1]`",
    ),
    (&["head"], "write `first(list)` or `xs[0]`"),
    (&["tail"], "write `xs[1..-1]`"),
    (&["foreach", "loop"], "write `[for x in xs: ...]`"),
    (&["repeat", "replicate", "array"], "write `[for i in 0..<n: ...]`"),
    (
        &["pattern", "linearpattern", "circularpattern", "polararray", "lineararray"],
        "write `[for i in 0..<n: translate(g, i * step)]`, with `rotate` for one that turns",
    ),
    (
        &["tostring", "string", "repr", "tostr"],
        "write `str(x)`, or the value within a text: `\"x = {x}\"`",
    ),
    (&["strip"], "write `replace(text, \" \", \"\")`"),
    (&["println", "printf", "display", "puts"], "write `print`, a statement of its own"),
    (&["expect", "ensure", "require"], "write `check a == b`, a statement of its own"),
    (&["save", "write"], "write `export shape to \"shape.step\"`, a statement of its own"),
    (&["include", "use"], "write `import \"other.geo\" as other`, a statement of its own"),
    (
        &["show", "view", "draw", "plot", "render"],
        "definitions of geometry are drawn as they stand; `virote view` and `virote render` show them",
    ),
    (&["matrix"], "write lists of rows, and `transform(g, rows)` for an affine map"),
    (
        &["group", "assembly", "compound", "part"],
        "a list or a record holds several: `let wheel = {hub, rim}`",
    ),
    (&["vertex"], "a point is written `(x, y, z)`; the corners of a solid are `s.vertices`"),
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
    (
        &["degree", "knots", "weights", "domain"],
        "what geometry consists of are its fields: `c.degree`, `c.knots`, `c.weights`, `c.domain`",
    ),
    (
        &["evaluate", "eval", "pointat", "parameter"],
        "a curve is called as `c(t)`, a surface as `s(u, v)`",
    ),
    (
        &["deriv", "derivatives", "diff"],
        "write `derivative(c, t)`; of numbers that a function yields, `gradient(f, at)`",
    ),
    (&["jacobian", "hessian"], "write `gradient(f, at)` for each of the numbers"),
    (
        &["elevatedegree", "degreeelevate", "increasedegree", "changedegree"],
        "write `elevate(c, degree)`",
    ),
    (&["insertknots", "knotinsert"], "write `insert_knot(c, t)`, or `refine(c, knots)`"),
    (&["subcurve", "trimcurve", "subcrv"], "write `trim(curve, a..b)`"),
    (&["reparam", "reparameterize"], "write `reparametrize(c, a..b)`"),
    (&["bbox", "boundingbox", "extents"], "write `bounds(g)`, which gives `{min, max}`"),
    (
        &["center", "centre", "centerofmass", "centroids"],
        "write `centroid(g)`; the middle of the box is that of `bounds(g)`",
    ),
    (&["mass"], "write `volume(g)` times a density"),
    (&["magnitude", "mag", "vectorlength"], "write `norm(v)`"),
    (&["dist"], "write `distance(a, b)`"),
    (&["optimize", "optimise", "fmin"], "write `minimize(f, within = a..b)` or `maximize`"),
    (&["root", "roots", "findroot", "fsolve", "goalseek"], "write `solve(f, within = a..b)`"),
    (&["quad", "integral"], "write `integrate(f, a..b)`"),
    (&["log"], "write `ln(x)` or `log10(x)`"),
    (&["log2"], "write `ln(x) / ln(2)`"),
    (&["exp2", "squared", "sqr"], "a power is written `a^b`"),
    (&["mix"], "write `lerp(a, b, t)`"),
    (
        &["rand", "rnd", "uniform", "noise", "seed"],
        "write `random(n, seed = 1)`: the same numbers on every run",
    ),
    (
        &["time", "date", "now", "today"],
        "a script says the same on every run, and so knows no time; give one by a `param`",
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
const BOOLEANS: &str = "plane regions and closed meshes are combined by `union`, `intersection` and `difference`; `trim` and `split` cut surfaces and faces, `cut` a solid by a plane";
const BY_FORMULA: &str = "write `parametric(t => (..., ..., ...), a..b)` of its formula";

/// What to write instead of `name`, when it is the habit of another language or program.
pub fn advice(name: &str) -> Option<&'static str> {
    let plain = name.replace('_', "").to_lowercase();
    let row = FOREIGN.iter().find(|(words, _)| words.contains(&plain.as_str()));
    row.map(|&(_, advice)| advice)
}

/// All words, each with what to write instead.
pub fn all() -> impl Iterator<Item = (&'static str, &'static str)> {
    FOREIGN.iter().flat_map(|&(words, advice)| words.iter().map(move |word| (*word, advice)))
}

/// The word that takes the place of `name`, where it is that word written otherwise.
pub(crate) fn word(name: &str) -> Option<&'static str> {
    let words = ["true", "false", "none", "pi"];
    match name {
        "null" | "nil" | "undef" | "undefined" => Some("none"),
        _ => words.into_iter().find(|word| name.eq_ignore_ascii_case(word)),
    }
}
