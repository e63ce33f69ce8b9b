//! `split` of a curve: both parts at a parameter.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// Both parts of a curve at a parameter, `[left, right]`, each with the parameters it had.
    ///
    /// Exact. `join` makes the same curve of them.
    split in Edit -> Vec<NurbsCurve> {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The parameter, inside the curve's domain and none of its ends.
        t: Spanned<f64>,
    }
    example "split(line((0, 0), (4, 8)), 0.25)[0].end" => "(1, 2, 0)";
    example "split(line((0, 0), (4, 8)), 0.25)[1].domain" => "0.25..1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    args.c.split(args.t.value).map(Vec::from).at(args.t.span)
}
