//! `split` of a curve: both parts at a parameter.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    value::{At, Ctx, op},
};

op! {
    /// Both parts of a curve at a parameter, `[left, right]`, each with the parameters it had.
    ///
    /// Exact. `join` makes the same curve of them.
    /// A parametric curve gives two of its kind.
    split in Edit -> Vec<Curve> {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain and none of its ends.
        t: Spanned<f64>,
    }
    example "split(line((0, 0), (4, 8)), 0.25)[0].end" => "(1, 2, 0)";
    example "split(line((0, 0), (4, 8)), 0.25)[1].domain" => "0.25..1";
    picture "split(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 0.4)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Curve>> {
    args.c.split(args.t.value).map(Vec::from).at(args.t.span)
}
