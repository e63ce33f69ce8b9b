//! `tangent` of a curve.

use super::varying;
use crate::{
    diag::{Result, Spanned},
    kernel::Side,
    value::{Choice, Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Unit tangent of a curve, in the direction of growing parameter.
    ///
    /// Where the first derivative vanishes, the direction of the first one that does not. At a
    /// corner the side decides.
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.
    tangent in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
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

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let plain = |t| args.c.tangent_at(t, args.side);
    varying::vector(&args.c, &args.t, args.side, plain, (1, varying::tangent))
}
