//! `split` of a curve: both parts at a parameter.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Both parts of a curve at a parameter, `[left, right]`, each with the parameters it had.
    ///
    /// Exact. `join` makes the same curve of them, unless it jumps.
    /// A parametric curve gives two of its kind.
    /// Piegl & Tiller, *The NURBS Book*, §5.2.
    split in Edit -> Vec<Curve> {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain and none of its ends.
        t: Spanned<f64>,
    }
    example "split(line((0, 0), (4, 8)), 0.25)[0].end" => "(1, 2, 0)";
    example "split(line((0, 0), (4, 8)), 0.25)[1].domain" => "0.25..1";
    refuses "split(bezier((0, 0), (1, 2), (2, 0)), 0)" => "E0606: parameter 0 is an end of the domain 0..1; there is nothing to split";
    refuses "split(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
    derivative shape;
    scene r#"
        let parts = split(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 0.4) with (hidden = true)
        curve left = parts[0]
        curve right = parts[1] with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Curve>> {
    args.c.split(args.t.value).map(Vec::from).at(args.t.span)
}
