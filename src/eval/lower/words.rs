//! Words that people bring along from other languages, and what to write here.

/// What to write instead of `name`, when it is the habit of another language.
pub(super) fn advice(name: &str) -> Option<&'static str> {
    Some(match name {
        "null" | "nil" | "undef" | "undefined" | "None" => "the empty value is written `none`",
        "True" => "write `true`",
        "False" => "write `false`",
        "PI" | "Pi" | "M_PI" => "write `pi`",
        "var" | "const" | "set" => "definitions begin with `let`",
        "function" | "def" | "func" | "module" => "functions are defined as `fn name(a, b) = ...`",
        "return" => "a function is one expression: `fn f(x) = x^2`",
        "echo" => "write `print`, a statement of its own",
        "isocurve" | "isocurves" | "isoline" | "iso_curve" => {
            "an isocurve is the surface with one parameter left out: `s(0.5, _)` or `s(_, 0.5)`"
        }
        "umbilic" | "umbilics" => "`describe(s).umbilics` lists the umbilics of a surface",
        "merge" => "`join` makes one curve of curves, and one surface of patches",
        "union" | "subtract" | "intersection" => {
            "surfaces are not combined as solids; `intersect(a, b)` tells where two of them cross"
        }
        "cube" | "cuboid" => "write `box(corner, size)`",
        "linear_extrude" => "write `extrude(curve, vector)`",
        "rotate_extrude" => "write `revolve(curve)`",
        _ => return None,
    })
}
