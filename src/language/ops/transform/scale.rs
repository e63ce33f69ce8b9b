//! `scale`: geometry made larger or smaller.

use glam::{DAffine3, DVec3};

use super::{about, apply};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    value::{Ctx, FromValue, Geometry, Mismatch, Type, Value, op},
};

op! {
    /// Geometry made larger or smaller from a point that stays, by one factor or by one along each
    /// axis.
    scale in Transform -> Geometry {
        /// What is scaled.
        g: Geometry,
        /// The factor, or three factors as a point; none is zero.
        s: Spanned<AxisFactors>,
        /// The point that stays.
        about: DVec3 = DVec3::ZERO,
    }
    example "scale((1, 2), 3)" => "(3, 6, 0)";
    example "scale((1, 2, 3), (1, 10, 100))" => "(1, 20, 300)";
    refuses "scale((1, 2), 0)" => "E0607: a factor of zero would flatten the geometry";
    derivative shape;
    picture "[for i in 1..4: scale(bezier((1, 0), (2, 2), (3, 0)), i/2)]";
}

/// A factor along each axis.
struct AxisFactors(DVec3);

impl FromValue for AxisFactors {
    const TYPE: Type = Type::OneOf(&[Type::Ratio, Type::Point]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(factors) => Ok(Self(*factors)),
            Value::Number(_) => {
                f64::from_value(value, span).map(|factor| Self(DVec3::splat(factor)))
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let factors = args.s.value.0;
    if factors.min_element() <= 0.0
        && 0.0 <= factors.max_element()
        && factors.to_array().contains(&0.0)
    {
        return Diagnostic::error(
            Code::Degenerate,
            args.s.span,
            "a factor of zero would flatten the geometry",
        )
        .hint("factors are given for x, y and z: `(2, 1, 1)`")
        .fail();
    }
    apply(&args.g, &about(DAffine3::from_scale(factors), args.about), ctx.span)
}
