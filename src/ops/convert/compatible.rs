//! `compatible`: curves on one basis.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsCurve, make_compatible},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The same curves on one degree and one knot vector, in the order given.
    ///
    /// The degree is the highest among them, the domain that of the first curve, and every knot of
    /// one is a knot of all. Piegl & Tiller, *The NURBS Book*, §10.3.
    compatible in Curve -> Vec<NurbsCurve> {
        /// The curves.
        curves: Spanned<AtLeast<1, Arc<NurbsCurve>>>,
    }
    example "[for c in compatible([line((0, 0), (2, 0)), clamped((0, 0), (1, 2), (3, 2), (4, 0), degree = 2)]): c.knots]" => "[[0, 0, 0, 0.5, 1, 1, 1], [0, 0, 0, 0.5, 1, 1, 1]]";
    example "compatible([line((0, 0), (2, 0)), bezier((0, 0), (1, 2), (2, 0))])[0].points" => "[(0, 0, 0), (1, 0, 0), (2, 0, 0)]";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let curves: Vec<NurbsCurve> =
        args.curves.value.0.iter().map(|curve| (**curve).clone()).collect();
    make_compatible(&curves).at(args.curves.span)
}
