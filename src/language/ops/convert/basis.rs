//! `basis`: the values of a curve's basis functions.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// Values at a parameter of the functions that blend a curve's control points, one a point.
    ///
    /// They sum to one. With weights they are the rational ones, so that the point of the curve
    /// is always the sum of points times values.
    /// Piegl & Tiller, *The NURBS Book*, (2.5) and (4.2).
    basis in Curve -> Vec<f64> {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
    }
    example "basis(bezier((0, 0), (1, 2), (2, 0)), 0.5)" => "[0.25, 0.5, 0.25]";
    example "basis(bezier((0, 0), (1, 2), (2, 0), weights = [1, 3, 1]), 0.5)" => "[0.125, 0.75, 0.125]";
    refuses "basis(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    let t = args.c.domain().clamp_inside(args.t.value).at(args.t.span)?;
    Ok(args.c.basis_at(t))
}
