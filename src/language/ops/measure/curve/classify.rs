//! `classify` of a curve: what kind of place a parameter is.

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, CurvePointKind},
    value::{At, Choice, Ctx, op},
};

op! {
    /// Kind of place that a parameter of a curve is.
    ///
    /// At a corner the tangent jumps, at a cusp it turns back; at an inflection it goes on and the
    /// curve bends to the other side. The ends of a closed curve are one place, those of an open
    /// one are regular.
    classify in Measure -> CurvePointKind {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
    }
    example "classify(circle((0, 0), 1), 0.3)" => "\"regular\"";
    example "classify(bezier((0, 0), (1, 1), (2, -1), (3, 0)), 0.5)" => "\"inflection\"";
    example "classify(bezier((0, 0), (1, 1), (0, 1), (1, 0)), 0.5)" => "\"cusp\"";
    example "classify(polyline((0, 0), (1, 0), (1, 1)), 1)" => "\"corner\"";
    refuses "classify(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

impl Choice for CurvePointKind {
    const WORDS: &'static [&'static str] = &["regular", "inflection", "cusp", "corner"];
    const MEANINGS: &'static [Self] = &[Self::Regular, Self::Inflection, Self::Cusp, Self::Corner];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<CurvePointKind> {
    let t = inside(&args.c, args.t)?;
    args.c.place_kind_at(t, ctx.tolerance).at(args.t.span)
}
