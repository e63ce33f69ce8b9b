//! `tangent` of a curve.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Side},
    value::{At, Choice, Ctx, op},
};

op! {
    /// Unit tangent of a curve, in the direction of growing parameter.
    ///
    /// Where the first derivative vanishes, the direction of the first one that does not. At a
    /// corner the side decides.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    tangent in Measure -> DVec3 {
        /// The curve.
        c: Curve,
        /// The parameter, inside the curve's domain.
        t: Spanned<f64>,
        /// The side of a corner: after it or before it.
        side: Side = Side::Right,
    }
    example "tangent(line((0, 0), (0, 5)), 0.5)" => "(0, 1, 0)";
    example "tangent(polyline((0, 0), (1, 0), (1, 1)), 1, side = \"left\")" => "(1, 0, 0)";
    refuses "tangent(bezier([(1, 2)]), 0.5)" => "E0607: there is no tangent at parameter 0.5: every derivative vanishes";
    refuses "tangent(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
}

impl Choice for Side {
    const WORDS: &'static [&'static str] = &["right", "left"];
    const MEANINGS: &'static [Self] = &[Self::Right, Self::Left];
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let t = inside(&args.c, args.t)?;
    args.c.tangent_at(t, args.side).at(args.t.span)
}
