//! `conic_kind`: which conic section a curve is.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{ConicKind, NurbsCurve},
    value::{At, Choice, Ctx, op},
};

op! {
    /// Which conic section a curve of degree 2 is; a circle is an ellipse.
    ///
    /// By the shape factor w1²/(w0·w2) of its weights: below 1 an ellipse, 1 a parabola, above 1
    /// a hyperbola. Piegl & Tiller, *The NURBS Book*, (7.22).
    conic_kind in Curve -> ConicKind {
        /// The curve, of degree 2.
        c: Spanned<Arc<NurbsCurve>>,
    }
    example "conic_kind(conic((0, 0), (1, 1), (2, 0), 1/2))" => "\"ellipse\"";
    example "conic_kind(bezier((0, 0), (1, 1), (2, 0)))" => "\"parabola\"";
    example "conic_kind(bezier((0, 0), (1, 1), (2, 0), weights = [1, 3, 4]))" => "\"hyperbola\"";
    refuses "conic_kind(line((0, 0), (1, 2)))" => "E0607: the curve is straight from parameter 0, which is no conic";
    refuses "conic_kind(bezier((0, 0), (1, 2), (2, 0), (3, 1)))" => "E0611: a conic has degree 2, but the curve has degree 3";
}

impl Choice for ConicKind {
    const WORDS: &'static [&'static str] = &["ellipse", "parabola", "hyperbola"];
    const MEANINGS: &'static [Self] = &[Self::Ellipse, Self::Parabola, Self::Hyperbola];
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<ConicKind> {
    args.c.value.conic_kind().at(args.c.span)
}
