//! `extend` of a curve: it goes on beyond an end.

use crate::{
    diag::{Result, Spanned},
    kernel::Curve,
    ops::positive,
    value::{At, Choice, Ctx, Length, op},
};

op! {
    /// Curve prolonged at an end by an arc length: its last polynomial piece goes on.
    ///
    /// The old part keeps its points and parameters, the domain grows, and there is no joint: all
    /// derivatives are continuous. Lines and circular arcs go on as such, an arc around its circle
    /// as often as the length says, with a joint where its polynomials reach no further.
    /// A parametric curve goes on as its function does beyond the domain.
    extend in Edit -> Curve {
        /// The curve.
        c: Curve,
        /// By how much, measured along the curve.
        length: Spanned<Length>,
        /// Which end.
        at: ExtendedEnd = ExtendedEnd::End,
    }
    example "extend(line((0, 0), (3, 4)), 10).end" => "(9, 12, 0)";
    example "extend(line((0, 0), (3, 4)), 5, at = \"start\").domain" => "-1..1";
    example "extend(arc((0, 0), 1, from = 0deg, to = 90deg), 4*pi).end ~= (0, 1)" => "true";
    refuses "extend(bezier((0, 0), (1, 2), (2, 0)), -1)" => "E0607: the length must be positive, found -1";
    refuses "extend(parametric(t => (t, sqrt(1 - t^2)), 0..0.5), 5)" => "E0502: a negative number (-0.12890625) has no square root";
    scene r#"
        curve longer = extend(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 1) with (color = "red")
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
    "#;
}

/// An end of a curve.
#[derive(Clone, Copy, PartialEq)]
enum ExtendedEnd {
    End,
    Start,
}

impl Choice for ExtendedEnd {
    const WORDS: &'static [&'static str] = &["end", "start"];
    const MEANINGS: &'static [Self] = &[Self::End, Self::Start];
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    let length = positive("the length", args.length)?;
    match args.at {
        ExtendedEnd::End => args.c.extended(length),
        ExtendedEnd::Start => args.c.extended_at_start(length),
    }
    .at(args.length.span)
}
