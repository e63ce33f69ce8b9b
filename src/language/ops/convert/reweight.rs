//! `reweight`: other weights for the same curve.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The same curve in space with every homogeneous point times a scalar spline.
    ///
    /// The spline is a curve whose x coordinate is the factor, positive, over the same domain; the
    /// degrees add up. Piegl & Tiller, *The NURBS Book*, (10.15).
    reweight in Curve -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The factor: a polynomial curve along the x axis.
        f: Spanned<Arc<NurbsCurve>>,
    }
    example "reweight(bezier((0, 0), (1, 2), (2, 0)), line((1, 0), (3, 0))).weights ~= [1, 5/3, 7/3, 3] within 1e-15" => "true";
    example "reweight(bezier((0, 0), (1, 2), (2, 0)), line((1, 0), (3, 0)))(0.5) ~= (1, 1) within 1e-15" => "true";
    refuses "reweight(bezier((0, 0), (1, 2), (2, 0)), line((1, 0), (-1, 0)))" => "E0607: the factor is -1; it must be above zero";
    refuses "reweight(bezier((0, 0), (1, 2), (2, 0)), line((1, 0), (3, 1)))" => "E0607: a scalar spline has its values in x, but y or z of point 1 is not zero";
    refuses "reweight(bezier((0, 0), (1, 2), (2, 0)), polyline((1, 0), (2, 0), (3, 0)))" => "E0606: the domains differ: 0..1 and 0..2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.reweighted(&args.f.value).at(args.f.span)
}
